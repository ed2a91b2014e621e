// The cavities of one molecule with one set of radii and one solvent radius, and all that is
// reported of them. Used by the sources of alphascope-cli cavities.
#pragma once

#include <string>
#include <vector>

#include "app/cli/cavities/cavities_options.hpp"
#include "app/cli/input.hpp"
#include "core/document/cavities/cavity_records.hpp"
#include "core/run/stage_timer.hpp"

namespace alphascope::cli {

// CavityFacts::rows are not below the volume asked for.
struct CavityAnswer : CavityFacts {
  Input input;

  StageTimes times;
  std::string device;  // "CPU, 2 threads"

  explicit CavityAnswer(const Input& of);
};

// Throws Cancelled.
CavityAnswer find_cavities_of(const Input& input, const CavitiesOptions& options,
                              double solvent_radius_angstrom, const RunContext& context);

// What a reader must know of the numbers.
std::vector<std::string> notes_of(const CavityAnswer& answer, const CavitiesOptions& options);

// As text on standard output.
void print_cavities(const CavityAnswer& answer, const CavitiesOptions& options);

}  // namespace alphascope::cli
