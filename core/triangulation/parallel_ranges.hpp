// One loop over many small items by all threads of the caller's task arena.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cstddef>

#include "core/run/cancel_token.hpp"

namespace alphascope {

// Calls body(n) for each n below `count`. Throws Cancelled; then some calls are left out.
template <class Body>
void parallel_ranges(std::size_t count, const CancelToken& cancel, const Body& body) {
  constexpr std::size_t kGrain = 512;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, kGrain),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      if (cancel.cancelled()) return;
                      for (std::size_t n = range.begin(); n != range.end(); ++n) body(n);
                    });
  cancel.throw_if_cancelled();
}

}  // namespace alphascope
