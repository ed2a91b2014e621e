// SPDX-License-Identifier: GPL-3.0-or-later
// Opens a molecule by the input options, and prepares its balls.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "app/cli/input_options.hpp"
#include "app/session/open_molecule.hpp"
#include "core/document/fetch/molecule_id.hpp"
#include "core/selection/provenance.hpp"

namespace alphascope::cli {

// A molecule and the balls of one of its models.
struct Input {
  OpenedMolecule opened;
  BallOptions balls;             // the chosen options, with balls.model of this model
  double open_milliseconds = 0;  // for reading (the first model only), selection and radii

  const Molecule& molecule() const { return *opened.molecule; }
  const PreparedBalls& prepared() const { return *opened.prepared; }
  Provenance provenance() const {
    return alphascope::provenance(molecule(), balls, prepared().report);
  }
};

// The file to open: the named one, or that of an id, which is fetched if it was not before. An
// existing file wins over an id. Throws UsageError for an invalid id, and as fetch_molecule() does.
std::filesystem::path local_file(const std::filesystem::path& named, const InputOptions& options,
                                 const RunContext& context);

// The file of an id, fetched now or before. Throws as fetch_molecule() does.
std::filesystem::path fetched_file(const MoleculeId& id, const InputOptions& options,
                                   const RunContext& context);

// Returns the options of open_molecule(). A table of radii is read here, once for all files. Throws
// UsageError for an unknown value, and ReadError for the table.
OpenOptions open_options(const InputOptions& options, const RunContext& context);

// Reads the file once and calls `use` with the chosen model, or with each in turn for --model all.
// Throws UsageError for an option that the molecule cannot satisfy, and as open_molecule() does.
void for_each_model(const std::filesystem::path& file, const InputOptions& options,
                    const OpenOptions& open, const RunContext& context,
                    const std::function<void(const Input&)>& use);
// The same for options.file.
void for_each_model(const InputOptions& options, const RunContext& context,
                    const std::function<void(const Input&)>& use);

// For commands that take one model. Throws UsageError with the reason `why_one` for --model all.
Input open_one_model(const InputOptions& options, const char* why_one, const RunContext& context);

// Returns the options for the atoms that bound cavities (the body). cavity_body() makes the choices
// that the user left open. The second function gives an open molecule the radii of its body.
OpenOptions body_options(const InputOptions& options, const BodyOptions& body,
                         const RunContext& context);
Input with_body_radii(Input input, const InputOptions& options);

// Sentences on assumptions: the reader's notes, and a note if no atom is left.
std::vector<std::string> input_notes(const Input& input);

// "FILE: used … of … atoms; …", with the notes on separate lines unless the program is quiet. Ends
// with a line end.
std::string input_text(const Input& input);

}  // namespace alphascope::cli
