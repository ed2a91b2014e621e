// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the nearest word by edit distance.
#include "app/options/did_you_mean.hpp"

#include <algorithm>
#include <cctype>

namespace alphascope {
namespace {

constexpr std::size_t kShortestWord = 3;  // all words of two letters are near each other
constexpr std::size_t kLongestWord = 64;  // longer words are not typing errors

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

// Returns the least number of letters to change, insert, remove or swap with a neighbour to turn a
// into b.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before_last[j - 2] + 1);
      }
    }
    std::swap(before_last, last);
    std::swap(last, row);
  }
  return last[b.size()];
}

}  // namespace

std::string did_you_mean(std::string_view word, const std::vector<std::string>& known) {
  const std::string typed = lower(word);
  if (typed.size() < kShortestWord || typed.size() > kLongestWord) return {};
  const std::string* nearest = nullptr;
  std::size_t least = 1 + std::max<std::size_t>(1, typed.size() / 3);
  for (const std::string& candidate : known) {
    // The beginning of a known word counts as nearer than any word with a typing error.
    const bool begun = typed.size() >= 3 && lower(candidate).starts_with(typed);
    const std::size_t far = begun ? 0 : distance(typed, lower(candidate));
    if (far >= least) continue;
    least = far;
    nearest = &candidate;
  }
  return nearest ? " Did you mean \"" + *nearest + "\"?" : std::string();
}

}  // namespace alphascope
