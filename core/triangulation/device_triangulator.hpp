// SPDX-License-Identifier: GPL-3.0-or-later
// The interface of a device that makes regular triangulations, and what follows from them.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "core/complex/outside_part.hpp"
#include "core/complex/triangulation.hpp"
#include "core/geometry/ball_index.hpp"
#include "core/predicates/flow_ties.hpp"
#include "core/run/cancel_token.hpp"
#include "core/triangulation/filtration_parts.hpp"
#include "core/triangulation/ground.hpp"
#include "core/triangulation/membership.hpp"
#include "core/triangulation/triangulation_report.hpp"

namespace alphascope {

struct BallSet;

// A triangulation by a device. It is certified: checked from the definition, in integers where
// floats do not decide.
struct DeviceTriangulation {
  std::optional<Triangulation> triangulation;  // empty: report.why_not says why
  TriangulationReport report;
};

// Finds a tetrahedron of the triangulation with which a device can begin, as seed_tetrahedron()
// does (core/wrapping/seed.hpp). The library of the device has no CGAL, so the program gives it
// this.
using FindSeed = std::function<std::optional<std::array<BallIndex, 4>>(const BallSet& balls,
                                                                       const CancelToken& cancel)>;

class DeviceTriangulator {
 public:
  virtual ~DeviceTriangulator() = default;

  // Works in the caller's task arena. Throws Cancelled. Two threads must not call it at once. A
  // failed device, too little memory and a failed certificate are reported in `why_not`.
  virtual DeviceTriangulation make(const BallSet& balls, const RunContext& context) = 0;

  // What follows from a triangulation of dimension 3 of these balls, made by any maker. Empty if
  // the device cannot make it, and `why_not` says why. They throw as make(), and count as calls of
  // it.
  virtual std::optional<FiltrationParts> filtration_parts(const BallSet& balls,
                                                          const Triangulation& triangulation,
                                                          const RunContext& context,
                                                          std::string& why_not) = 0;
  virtual std::optional<TriangulationGround> ground(const BallSet& balls,
                                                    const Triangulation& triangulation,
                                                    FlowTies ties, const RunContext& context,
                                                    std::string& why_not) = 0;

  // Membership at one alpha (core/triangulation/membership.hpp), if these incidences are those of
  // the last ground() and are still on the device. Else empty; also if the device fails.
  virtual std::optional<Membership> membership(const Incidence& incidence,
                                               const LatticeAlpha& alpha_on_lattice,
                                               const CancelToken& cancel) = 0;

  // The parts outside the balls (core/cavity/tetrahedron_outside.hpp) of these tetrahedra, if `in`
  // is the last membership() and is still on the device. Else empty; also if the device fails. At
  // that alpha no ball may be smaller than the solvent radius, lattice units.
  virtual std::optional<ResultArray<OutsidePart>> outside_parts(
      const Membership& in, std::span<const std::uint32_t> tetrahedra, double solvent_on_lattice,
      const CancelToken& cancel) = 0;

  // Whether the memory that is kept for the next call takes room that others may need: less than
  // half of the device's memory is free. Asks the driver only if the last call had more balls than
  // those before it.
  virtual bool takes_much_room() = 0;

  // Frees the memory that is kept for the next call. May wait for the device. Two threads must not
  // call it at once, nor together with make().
  virtual void release_memory() = 0;
};

}  // namespace alphascope
