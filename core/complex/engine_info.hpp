// SPDX-License-Identifier: GPL-3.0-or-later
// The engine that made a result, and what it counted.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace alphascope {

// A number that an engine counted, for display.
struct EngineCounter {
  std::string name;  // "4-tuples into kernel II"
  std::uint64_t value = 0;
};

// The engine that made the result, for display and provenance.
struct EngineInfo {
  std::string name;    // "dual-edge engine", "CGAL triangulation"
  std::string device;  // "CPU, 2 threads", "NVIDIA H200"
  std::string route;   // what this run did: "dual edge clipping", "regular triangulation, then
                       // threshold", "threshold of cached filtration"
  std::vector<EngineCounter> counters = {};  // empty where nothing is counted
  // The result was taken from the triangulation of all balls, as CGAL's results are.
  bool of_whole = false;
  // That was CGAL's, so equality with CGAL is no evidence.
  bool rests_on_cgal = false;
};

}  // namespace alphascope
