// Where the numbers of a table come from, for whatever is written of it.
#pragma once

#include <memory>
#include <string>

#include "core/molecule/prepare_balls.hpp"
#include "core/molecule/provenance.hpp"

namespace alphascope {

// Who computed: "alphascope", "0.1.0", "0123456789ab".
struct ProgramName {
  std::string name, version, commit;
  std::string text() const { return name + " " + version + " (" + commit + ")"; }
};

struct RecordSource {
  std::shared_ptr<const Molecule> molecule;       // with an assembly's copies
  std::shared_ptr<const PreparedBalls> prepared;  // its balls, without solvent radius
  BallOptions options;                            // that they were chosen by
  ProgramName program;
  double open_milliseconds = 0;  // that reading took; 0: not measured

  Provenance provenance() const {
    return alphascope::provenance(*molecule, options, prepared->report);
  }
};

}  // namespace alphascope
