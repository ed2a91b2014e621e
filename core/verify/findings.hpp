// SPDX-License-Identifier: GPL-3.0-or-later
// Counts the verifier's checks and collects its messages, from many threads at once.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <functional>
#include <mutex>
#include <string>
#include <utility>

#include "core/complex/simplices.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/verify/verify.hpp"

namespace alphascope {

struct BallSet;

class Findings {
 public:
  template <int N>
  void check(bool good, const std::array<BallIndex, N>& simplex, const char* what) {
    ++checks_;
    if (good) return;
    const std::lock_guard lock(mutex_);
    ++result_.failures;
    if (result_.messages.size() >= kMaxMessages) return;
    std::string name;
    for (const BallIndex v : simplex) name += (name.empty() ? "" : " ") + std::to_string(v);
    result_.messages.push_back("simplex {" + name + "}: " + what);
  }
  void check(bool good, const std::string& what) {
    if (good) {
      ++checks_;
    } else {
      fail(what);
    }
  }
  void fail(const std::string& what) {
    ++checks_;
    const std::lock_guard lock(mutex_);
    ++result_.failures;
    if (result_.messages.size() < kMaxMessages) result_.messages.push_back(what);
  }
  // Do not call this while other threads check.
  bool good() const { return result_.failures == 0; }
  Verification take() {
    result_.checks = checks_;
    return std::move(result_);
  }

 private:
  static constexpr std::size_t kMaxMessages = 20;

  std::mutex mutex_;
  std::atomic<std::size_t> checks_ = 0;
  Verification result_;
};

// Checks that a list of simplices of these balls is in lexicographic order without duplicates, with
// the balls of each simplex ascending. False if other checks cannot safely index the list.
template <int N>
bool check_order(const BallSet& balls, const Simplices<N>& list, Findings& findings) {
  bool sound = true;
  for (std::size_t n = 0; n < list.size(); ++n) {
    const auto& s = list[n];
    const bool ascending =
        std::adjacent_find(s.begin(), s.end(), std::greater_equal<>()) == s.end();
    const bool good = s[N - 1] < balls.size() && ascending && (n == 0 || list[n - 1] < s);
    findings.check<N>(good, s, "vertices or list out of order, or no such ball");
    sound = sound && good;
  }
  return sound;
}

}  // namespace alphascope
