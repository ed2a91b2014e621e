// SPDX-License-Identifier: GPL-3.0-or-later
// The interface of a device that makes regular triangulations.
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "core/complex/triangulation.hpp"
#include "core/geometry/ball_index.hpp"
#include "core/run/cancel_token.hpp"
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

  // Whether the memory that is kept for the next call takes room that others may need: less than
  // half of the device's memory is free. Asks the driver only if the last call had more balls than
  // those before it.
  virtual bool takes_much_room() = 0;

  // Frees the memory that is kept for the next call. May wait for the device. Two threads must not
  // call it at once, nor together with make().
  virtual void release_memory() = 0;
};

}  // namespace alphascope
