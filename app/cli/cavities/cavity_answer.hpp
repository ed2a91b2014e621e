// SPDX-License-Identifier: GPL-3.0-or-later
// The cavities of one molecule with one radii set and one solvent radius, and facts about them. The
// sources of alphascope-cli cavities use it.
#pragma once

#include <string>
#include <vector>

#include "app/cli/cavities/cavities_options.hpp"
#include "app/cli/input.hpp"
#include "core/document/cavities/cavity_records.hpp"
#include "core/run/stage_timer.hpp"

namespace alphascope::cli {

// CavityFacts::rows holds only cavities of at least the requested volume.
struct CavityAnswer : CavityFacts {
  Input input;

  StageTimes times;
  std::string device;  // "CPU, 2 threads"

  explicit CavityAnswer(const Input& of);
};

// Finds the cavities. Throws Cancelled.
CavityAnswer find_cavities_of(const Input& input, const CavitiesOptions& options,
                              double solvent_radius_angstrom, const RunContext& context);

// Returns sentences that explain the numbers, such as differences from CASTp.
std::vector<std::string> notes_of(const CavityAnswer& answer, const CavitiesOptions& options);

// Prints the table as text to standard output.
void print_cavities(const CavityAnswer& answer, const CavitiesOptions& options);

}  // namespace alphascope::cli
