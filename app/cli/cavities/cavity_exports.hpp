// SPDX-License-Identifier: GPL-3.0-or-later
// Files of alphascope-cli cavities besides its tables: lives of cavities and, for other programs,
// spheres, surfaces and scripts.
#pragma once

#include "app/cli/cavities/cavity_answer.hpp"
#include "app/cli/cavities/shape_outputs.hpp"
#include "app/cli/outputs.hpp"

namespace alphascope::cli {

// The files are opened before the computation. Null: not requested.
class CavityExports {
 public:
  // Throws UsageError for an unknown ending, for standard input, and for input that gives several
  // answers. Also throws as Outputs::add() does.
  CavityExports(const CavitiesOptions& options, Outputs& outputs);

  const ShapeOutputs& shapes() const { return shapes_; }
  // Writes the lives of all cavities, and the other files for the listed ones. Throws WriteError,
  // Cancelled, and UsageError for molecules that a script cannot describe.
  void write(const CavityAnswer& answer, const RunContext& context);

 private:
  void write_lives(const CavityAnswer& answer);
  void write_script(const CavityAnswer& answer);

  ShapeOutputs shapes_;
  AtomicFile* lives_;
};

}  // namespace alphascope::cli
