// SPDX-License-Identifier: GPL-3.0-or-later
// The regular triangulation by inserting balls, on one thread or many.
#pragma once

#include <optional>

#include "core/complex/triangulation.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

struct BallSet;

// How balls were inserted.
struct InsertionCounts {
  int threads = 1;
  std::size_t inserters = 1;     // at the same time, at most
  std::uint64_t put_off = 0;     // insertions that were begun and put off
  std::uint64_t one_by_one = 0;  // balls that were inserted on one thread
};

// The triangulation of balls whose centres span space; empty if they do not. `threads`, at least
// 1, changes only the time. Works in the caller's task arena. Throws Cancelled,
// std::bad_alloc, and std::length_error for more balls or tetrahedra than can be handled.
std::optional<Triangulation> triangulate_by_insertion(const BallSet& balls, int threads,
                                                      const RunContext& context,
                                                      InsertionCounts* counts = nullptr);

}  // namespace alphascope
