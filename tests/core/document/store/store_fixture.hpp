// SPDX-License-Identifier: GPL-3.0-or-later
// A store, with results that take as long as a test needs.
#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <thread>

#include "core/document/store/inputs.hpp"
#include "core/document/store/store.hpp"
#include "core/triangulation/memory_need.hpp"

namespace alphascope::testing {

struct StoreTest : ::testing::Test {
  static constexpr std::chrono::milliseconds kShort{1};

  std::atomic<int> made{0};
  std::atomic<bool> hold{false};  // no result is finished while this is set
  std::uint64_t budget = 1000;
  Store store{{}, [this] { return budget; }};

  Definition<int> number(std::string_view id, std::uint64_t bytes = 10, bool keep_stale = true) {
    return {{.id = id,
             .title = id,
             .key = key_of_balls,
             .memory =
                 [bytes](const Inputs&) {
                   return MemoryNeed{bytes, bytes};
                 },
             .keep_stale = keep_stale},
            [this](const Inputs& in, const RunContext& context) {
              ++made;
              wait_while_held(context);
              return std::make_shared<const int>(static_cast<int>(in.balls_key));
            }};
  }
  // A result that follows the slider: alpha as a number.
  Definition<double> table(std::string_view id, std::uint64_t bytes = 10) {
    return {{.id = id,
             .title = id,
             .key = key_of_balls_and_alpha,
             .memory =
                 [bytes](const Inputs&) {
                   return MemoryNeed{bytes, bytes};
                 },
             .lane = Lane::interactive},
            [this](const Inputs& in, const RunContext& context) {
              ++made;
              wait_while_held(context);
              return std::make_shared<const double>(in.alpha_angstrom2);
            }};
  }
  void wait_while_held(const RunContext& context) const {
    while (hold) {
      context.cancel.throw_if_cancelled();
      std::this_thread::sleep_for(kShort);
    }
  }

  static Inputs inputs(std::uint64_t balls, double alpha = 0) {
    Inputs in;
    in.balls_key = balls;
    in.alpha_angstrom2 = alpha;
    return in;
  }
  void frame() {
    store.next_frame();
    store.poll();
  }
  template <class T>
  void begin(const Definition<T>& definition, const Inputs& in) {  // requires hold
    const int before = made;
    while (made == before) {
      store.want(definition, in);
      frame();
    }
  }
  template <class T>
  Derived<T> settle(const Definition<T>& definition, const Inputs& in) {
    Derived<T> d;
    for (int i = 0; i < 60000; ++i) {
      d = store.want(definition, in);
      if (d.state != DerivedState::waiting && d.state != DerivedState::running) return d;
      frame();
      std::this_thread::sleep_for(kShort);
    }
    ADD_FAILURE() << "not made in a minute";
    return d;
  }
};

}  // namespace alphascope::testing
