// SPDX-License-Identifier: GPL-3.0-or-later
// Completes a triangulation on a GPU: from some of its tetrahedra it finds all others. Plain C++.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/geometry/ball_index.hpp"
#include "core/run/cancel_token.hpp"
#include "gpu/dual_edge/dual_edge_pipeline.hpp"
#include "gpu/memory/device_complex.hpp"

namespace alphascope {

struct BallSet;

namespace gpu {

struct Wrapped;

struct WrappingResult {
  // Those that were not known. The balls of each ascend; the order is that in which they were
  // found.
  std::vector<std::array<BallIndex, 4>> found;
  std::size_t known = 0, hull = 0;   // numbers of known tetrahedra, of faces on the hull
  std::size_t open = 0, needed = 0;  // open faces of the known, and balls that can touch them
  std::size_t rounds = 0;
  // Numbers of faces for each search (front.cuh).
  static constexpr int kSearches = 5;
  std::array<std::size_t, kSearches> searched{};
  bool fits = true;  // false: there was no room for all
  // Milliseconds by the device's clock.
  double order_ms = 0, open_ms = 0, tree_ms = 0, front_ms = 0;
  // Of a timed run: numbers and milliseconds of each round.
  struct Round {
    std::array<std::size_t, kSearches> faces{};
    std::array<double, kSearches + 1> milliseconds{};  // the last: adding tetrahedra
  };
  std::vector<Round> timed;
};

class Wrapping {
 public:
  Wrapping();
  explicit Wrapping(const BallSet& balls) : Wrapping() { load(balls); }
  ~Wrapping();

  // Copies the balls to the device, and puts them in order. There must be from 1 to kMost. Throws
  // std::bad_alloc and DeviceError.
  static constexpr std::size_t kMost = std::size_t{1} << 24;
  void load(const BallSet& balls);

  // The balls in device memory, without those that others with the same centre hide. Empty if too
  // many are so close together that this was not found out.
  std::optional<DeviceBalls> shown_balls();

  // The distance from a ball to the nearest of the few that follow it in that order, lattice units:
  // the first decile, which tells how dense the denser parts are.
  double small_gap();

  // `known`: at least one tetrahedron of the regular triangulation. `radius`: a guess at the radius
  // of the next orthospheres, lattice units; it changes only the time. `room`: of new tetrahedra.
  // `bring`: whether the result has `found`. `timed`: measures each round, which takes longer.
  // Throws Cancelled, std::bad_alloc and DeviceError.
  WrappingResult run(std::span<const std::array<BallIndex, 4>> known, double radius,
                     std::size_t room, bool bring, const CancelToken& cancel, bool timed = false);
  // The same for known tetrahedra in device memory.
  WrappingResult run(const DeviceSimplices& known, double radius, std::size_t room, bool bring,
                     const CancelToken& cancel, bool timed = false);

  // Queues the marking of all vertices and hidden balls (Wrapped::found), by the first `count`
  // tetrahedra after a run whose result fits.
  void mark_balls(std::uint32_t count);

  // All tetrahedra after a run whose result fits (wrapped.cuh).
  const Wrapped& on_device() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace gpu
}  // namespace alphascope
