// Provenance of results, for files that contain them.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/document/export/program_name.hpp"
#include "core/geometry/lattice.hpp"
#include "core/selection/prepare_balls.hpp"
#include "core/selection/provenance.hpp"

namespace alphascope {

struct RecordSource {
  std::shared_ptr<const Molecule> molecule;       // with an assembly's copies
  std::shared_ptr<const PreparedBalls> prepared;  // its balls, without solvent radius
  BallOptions options;                            // options by which the balls were chosen
  ProgramName program;
  double open_milliseconds = 0;  // for reading the file; 0: not measured

  // Lattice of the balls of the results. A solvent radius may have moved them to a finer one.
  std::optional<Lattice> refined = {};

  Lattice lattice() const { return refined.value_or(prepared->balls->lattice); }
  RecordSource on(const Lattice& lattice) const {
    RecordSource source = *this;
    source.refined = lattice;
    return source;
  }
  Provenance provenance() const {
    Provenance entries = alphascope::provenance(*molecule, options, prepared->report);
    for (auto& [key, value] : entries) {
      if (key == "lattice_unit_angstrom") value = lattice_unit_text(lattice());
    }
    return entries;
  }
};

}  // namespace alphascope
