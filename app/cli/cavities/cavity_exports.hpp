// What alphascope-cli cavities writes beside its tables: lives; and for other programs spheres,
// surfaces, scripts.
#pragma once

#include "app/cli/cavities/cavity_answer.hpp"
#include "app/cli/cavities/shape_outputs.hpp"
#include "app/cli/outputs.hpp"

namespace alphascope::cli {

// Opened before anything is computed; null is not asked for.
class CavityExports {
 public:
  // Throws UsageError for a name with another ending than there are formats, for what is on
  // standard input or makes several answers, and what Outputs::add() throws.
  CavityExports(const CavitiesOptions& options, Outputs& outputs);

  const ShapeOutputs& shapes() const { return shapes_; }
  // Of the cavities that are listed, but lives of all. Throws WriteError, Cancelled, and UsageError
  // for what cannot be said in a script.
  void write(const CavityAnswer& answer, const RunContext& context);

 private:
  void write_lives(const CavityAnswer& answer);
  void write_script(const CavityAnswer& answer);

  ShapeOutputs shapes_;
  AtomicFile* lives_;
};

}  // namespace alphascope::cli
