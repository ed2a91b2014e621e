// From the input options to an open molecule.
#pragma once

#include <string>

#include "app/cli/commands.hpp"

namespace alphascope::cli {

struct Input {
  OpenedMolecule opened;
  std::string selection_expression;
  double open_milliseconds = 0;  // reading, selecting, radii

  const Molecule& molecule() const { return *opened.molecule; }
  const PreparedBalls& prepared() const { return *opened.prepared; }
};

// Throws UsageError for an option that says nothing known, and what open_molecule() throws.
Input open_input(const InputOptions& options, const RunContext& context);

// "FILE: used … of … atoms; …", with the reader's notes on lines of their own; ended.
std::string input_text(const Input& input);

}  // namespace alphascope::cli
