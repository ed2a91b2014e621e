// SPDX-License-Identifier: GPL-3.0-or-later
// Incidences and flow of a triangulation: all that a search for cavities needs beside alpha.
#pragma once

#include "core/triangulation/flow.hpp"
#include "core/triangulation/incidence.hpp"

namespace alphascope {

struct TriangulationGround {
  Incidence incidence;
  Flow flow;
};

}  // namespace alphascope
