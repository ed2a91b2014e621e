// SPDX-License-Identifier: GPL-3.0-or-later
// Who made a triangulation, and how.
#pragma once

#include <cstdint>
#include <string>

#include "core/complex/triangulation.hpp"
#include "core/run/stage_timer.hpp"

namespace alphascope {

struct TriangulationReport {
  std::string maker;    // "NVIDIA H200", "CGAL"
  bool by_cgal = true;  // else made and certified by a device
  // Why a device that is there did not make it: a sentence without its full stop.
  std::string why_not;
  StageTimes timings;
  // Of a device only.
  std::uint64_t known = 0;       // tetrahedra with which wrapping began
  std::uint64_t open_faces = 0;  // faces of those without a neighbour
  std::uint64_t needed = 0;      // balls that the next tetrahedra can have
  std::uint64_t rounds = 0;      // of wrapping
};

// Whether a device made it, so that its equality with CGAL's triangulation is evidence.
inline bool made_by_device(const Triangulation& triangulation) {
  return triangulation.report && !triangulation.report->by_cgal;
}

}  // namespace alphascope
