// From the input options to an open molecule and its balls.
#pragma once

#include <functional>
#include <string>

#include "app/cli/commands.hpp"
#include "core/molecule/provenance.hpp"

namespace alphascope::cli {

// A molecule and the balls of one of its models.
struct Input {
  OpenedMolecule opened;
  BallOptions balls;             // what was chosen; balls.model is this one
  double open_milliseconds = 0;  // reading (the first model only), selecting, radii

  const Molecule& molecule() const { return *opened.molecule; }
  const PreparedBalls& prepared() const { return *opened.prepared; }
  Provenance provenance() const {
    return alphascope::provenance(molecule(), balls, prepared().report);
  }
};

// Reads the file once and calls `use` with the model asked for, or with --model all with each in
// turn. Throws UsageError for an option that says nothing known, and what open_molecule() throws.
void for_each_model(const InputOptions& options, const RunContext& context,
                    const std::function<void(const Input&)>& use);

// For commands that take one model: UsageError, with this reason, for --model all.
Input open_one_model(const InputOptions& options, const char* why_one, const RunContext& context);

inline bool each_model(const InputOptions& options) {
  return options.model == "all";
}

// "FILE: used … of … atoms; …", with the reader's notes on lines of their own; ended.
std::string input_text(const Input& input);

}  // namespace alphascope::cli
