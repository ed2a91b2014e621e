// SPDX-License-Identifier: GPL-3.0-or-later
// Makes all that follows from a triangulation on a CUDA device: its faces and their incidences, its
// flow, alpha values and levels. The same as core/triangulation makes on the CPU. Plain C++.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "core/complex/outside_part.hpp"
#include "core/triangulation/filtration_parts.hpp"
#include "core/triangulation/ground.hpp"
#include "core/triangulation/membership.hpp"

namespace alphascope::gpu {

// Tetrahedra and neighbours of a triangulation in device memory, as Triangulation has them. The
// index of a facet of the hull may be any.
struct TriangulationOnDevice {
  const void *tetrahedra = nullptr, *neighbours = nullptr;
};

class FacesMaker {
 public:
  FacesMaker();  // throws DeviceError
  ~FacesMaker();

  // `there`: the triangulation in device memory, if it is there. Empty if the device cannot make
  // them, and `why_not` says why. Throw Cancelled, std::bad_alloc and DeviceError.
  std::optional<FiltrationParts> filtration_parts(const BallSet& balls,
                                                  const Triangulation& triangulation,
                                                  const TriangulationOnDevice& there,
                                                  const RunContext& context, std::string& why_not);
  std::optional<TriangulationGround> ground(const BallSet& balls,
                                            const Triangulation& triangulation,
                                            const TriangulationOnDevice& there, FlowTies ties,
                                            const RunContext& context, std::string& why_not);

  // Membership at one alpha, if these incidences are those of the last ground that was made, and
  // nothing was made since. Else empty.
  std::optional<Membership> membership(const Incidence& incidence, const LatticeAlpha& alpha,
                                       const CancelToken& cancel);
  // The parts outside the balls of these tetrahedra, if `in` is the last membership that was made,
  // and nothing was made since. Else empty. No grown ball is smaller than the solvent radius.
  std::optional<ResultArray<OutsidePart>> outside_parts(const Membership& in,
                                                        std::span<const std::uint32_t> tetrahedra,
                                                        double solvent_on_lattice,
                                                        const CancelToken& cancel);
  // Must be called when the triangulation that was there is not any more.
  void forget_ground();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace alphascope::gpu
