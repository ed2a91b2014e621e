// From the input options to an open molecule and its balls.
#pragma once

#include <functional>
#include <string>

#include "app/cli/input_options.hpp"
#include "app/session/open_molecule.hpp"
#include "core/selection/provenance.hpp"

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

// What the options say to open_molecule(), with a table of radii read: for files opened one after
// another. Throws UsageError for an option that says nothing known, ReadError for the table.
OpenOptions open_options(const InputOptions& options, const RunContext& context);

// Reads the file once and calls `use` with the model asked for, or with --model all with each in
// turn. Throws UsageError for an option that the molecule cannot satisfy, and what open_molecule()
// throws.
void for_each_model(const std::filesystem::path& file, const InputOptions& options,
                    const OpenOptions& open, const RunContext& context,
                    const std::function<void(const Input&)>& use);
// The same of options.file.
void for_each_model(const InputOptions& options, const RunContext& context,
                    const std::function<void(const Input&)>& use);

// For commands that take one model: UsageError, with this reason, for --model all.
Input open_one_model(const InputOptions& options, const char* why_one, const RunContext& context);

// The same of the body whose cavities are looked for: cavity_body()'s choices where the options
// make none. What is open already gets its radii by with_body_radii().
OpenOptions body_options(const InputOptions& options, const BodyOptions& body,
                         const RunContext& context);
Input with_body_radii(Input input, const InputOptions& options);

// Sentences about what had to be assumed: the reader's notes, and that no atom is left.
std::vector<std::string> input_notes(const Input& input);

// "FILE: used … of … atoms; …", with the notes on lines of their own unless the program is to be
// quiet; ended.
std::string input_text(const Input& input);

}  // namespace alphascope::cli
