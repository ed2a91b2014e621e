// SPDX-License-Identifier: GPL-3.0-or-later
// The loop of the verifier: in parallel, with progress, and cancelled after a few simplices.
#pragma once

#include <algorithm>
#include <cstddef>

#include "core/run/cancel_token.hpp"
#include "core/run/parallel.hpp"
#include "core/run/stage_timer.hpp"

namespace alphascope {

// Calls body(n) for every n below `count`, in the caller's task arena. Throws Cancelled.
template <class Body>
void verify_all(std::size_t count, const RunContext& context, const Body& body) {
  constexpr std::size_t kGrain = 64, kReports = 50;
  const std::size_t piece = std::max(kGrain * 64, count / kReports + 1);
  for (std::size_t begin = 0; begin < count; begin += piece) {
    context.report(stage::kDefinition, static_cast<double>(begin) / static_cast<double>(count));
    const std::size_t end = std::min(count, begin + piece);
    parallel_ranges(begin, end, kGrain, [&](std::size_t first, std::size_t last) {
      for (std::size_t n = first; n != last; ++n) {
        if (context.cancel.cancelled()) return;
        body(n);
      }
    });
    context.cancel.throw_if_cancelled();
  }
}

}  // namespace alphascope
