// SPDX-License-Identifier: GPL-3.0-or-later
// Who made a triangulation, and how.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "core/complex/triangulation.hpp"
#include "core/run/stage_timer.hpp"

namespace alphascope {

struct TriangulationReport {
  enum class By : std::uint8_t {
    cgal,
    insertion,  // core/insertion
    device      // which has certified it
  };
  By by = By::cgal;
  std::string maker;  // "NVIDIA H200", "CPU, 2 threads", "CGAL"
  // Why a device that is there did not make it: a sentence without its full stop.
  std::string why_not;
  StageTimes timings;
  // Of insertion only (InsertionCounts).
  std::size_t inserters = 0;
  std::uint64_t put_off = 0;
  // Of a device only.
  std::uint64_t known = 0;       // tetrahedra with which wrapping began
  std::uint64_t open_faces = 0;  // faces of those without a neighbour
  std::uint64_t needed = 0;      // balls that the next tetrahedra can have: |U|
  std::uint64_t waves = 0;       // of wrapping; each closes all open faces at once
};

inline bool made_by(TriangulationReport::By by, const Triangulation& triangulation) {
  return triangulation.report && triangulation.report->by == by;
}
inline bool made_by_device(const Triangulation& triangulation) {
  return made_by(TriangulationReport::By::device, triangulation);
}
// Then equality with CGAL's triangulation is no evidence.
inline bool made_by_cgal(const Triangulation& triangulation) {
  return !triangulation.report || made_by(TriangulationReport::By::cgal, triangulation);
}

}  // namespace alphascope
