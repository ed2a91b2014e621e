// SPDX-License-Identifier: GPL-3.0-or-later
// Loops whose parts run in parallel, on the threads of the caller's task arena. A body may be
// called on any of them. If it throws, the caller gets the exception, and parts that have not begun
// are skipped.
//
// parallel.cpp alone calls oneTBB for them: each call takes 0.15 s to compile, and oneTBB's headers
// take 0.6 s or more in each source.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "core/run/cancel_token.hpp"

namespace alphascope {

// Shared by the loops below, not for other callers. `call` gets `body` and a range of indices.
using CallRange = void (*)(const void* body, std::size_t begin, std::size_t end);
using CallSumRange = std::uint64_t (*)(const void* body, std::size_t begin, std::size_t end);
void run_ranges(std::size_t begin, std::size_t end, std::size_t grain, const void* body,
                CallRange call);
std::uint64_t sum_ranges(std::size_t begin, std::size_t end, std::size_t grain, const void* body,
                         CallSumRange call);

// Calls body(first, last) for ranges [first, last) that divide [begin, end), each index in one of
// them. A range of more than `grain` indices may be halved.
template <class Index, class Body>
void parallel_ranges(std::type_identity_t<Index> begin, Index end, std::size_t grain,
                     const Body& body) {
  static_assert(std::is_unsigned_v<Index>);
  run_ranges(begin, end, grain, &body, [](const void* of, std::size_t first, std::size_t last) {
    (*static_cast<const Body*>(of))(static_cast<Index>(first), static_cast<Index>(last));
  });
}

// Calls body(n) for each n of [begin, end).
template <class Index, class Body>
void parallel_each(std::type_identity_t<Index> begin, Index end, const Body& body) {
  static_assert(std::is_unsigned_v<Index>);
  // This loop is in the header so that the compiler can inline the body.
  run_ranges(begin, end, 1, &body, [](const void* of, std::size_t first, std::size_t last) {
    const Body& each = *static_cast<const Body*>(of);
    for (std::size_t n = first; n != last; ++n) each(static_cast<Index>(n));
  });
}

// Calls body(n) for each n below `count`. It is for many calls that take little time each. Throws
// Cancelled; some calls are skipped then.
template <class Body>
void parallel_many(std::size_t count, const CancelToken& cancel, const Body& body) {
  constexpr std::size_t kGrain = 512;
  parallel_ranges(0, count, kGrain, [&](std::size_t first, std::size_t last) {
    if (cancel.cancelled()) return;
    for (std::size_t n = first; n != last; ++n) body(n);
  });
  cancel.throw_if_cancelled();
}

// The sum, modulo 2^64, of body(first, last) over the ranges of parallel_ranges().
template <class Body>
std::uint64_t parallel_sum(std::size_t begin, std::size_t end, std::size_t grain,
                           const Body& body) {
  return sum_ranges(begin, end, grain, &body,
                    [](const void* of, std::size_t first, std::size_t last) -> std::uint64_t {
                      return (*static_cast<const Body*>(of))(first, last);
                    });
}

}  // namespace alphascope
