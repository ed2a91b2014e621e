// SPDX-License-Identifier: GPL-3.0-or-later
// Provenance of results, for files that contain them.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/document/export/program_name.hpp"
#include "core/geometry/lattice.hpp"
#include "core/selection/ball_options.hpp"

namespace alphascope {

struct Molecule;
struct PreparedBalls;

struct RecordSource {
  std::shared_ptr<const Molecule> molecule;       // with an assembly's copies
  std::shared_ptr<const PreparedBalls> prepared;  // its balls, without solvent radius
  BallOptions options;                            // options by which the balls were chosen
  ProgramName program;
  double open_milliseconds = 0;  // for reading the file; 0: not measured

  // Lattice of the balls of the results. A solvent radius may have moved them to a finer one.
  std::optional<Lattice> refined = {};

  Lattice lattice() const;
  RecordSource on(const Lattice& lattice) const;
  std::vector<std::pair<std::string, std::string>> provenance() const;  // of provenance.hpp
};

}  // namespace alphascope
