// SPDX-License-Identifier: GPL-3.0-or-later
// The input options: the file, its format, and the atoms that become balls.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace alphascope::cli {

struct InputOptions {
  std::filesystem::path file;   // "-" for standard input
  std::string format = "auto";  // or an id for format_from_id()
  std::string radii = "auto";   // id of a radii set, or path of a table of radii
  std::string model = "1";      // from 1; "all": each model separately; "joined": all models as one
  std::string hydrogens = "auto", altlocs = "best";
  bool waters = false, dummies = false, no_ligands = false, no_ions = false, no_polymers = false;
  std::vector<std::string> chains, without_chains, treated;
  std::string select;    // an expression of core/selection/selection_expression.hpp
  std::string assembly;  // id; empty: as deposited
  // For ids in place of files: ask no server, or ask even if the file was fetched before.
  bool offline = false, fetch_again = false;
};

inline bool each_model(const InputOptions& options) {
  return options.model == "all";
}

// The input files of a command that takes many.
struct InputFiles {
  std::vector<std::string> named;
  std::string list;             // path of a list of names; "-" is standard input, empty is none
  bool null_separated = false;  // each name in the list ends with NUL instead of a line end
  // With many files results form a table, and an error does not end the run.
  bool many() const { return named.size() > 1 || !list.empty(); }
};

// Which atoms besides proteins and nucleic acids bound cavities.
struct BodyOptions {
  bool ligands = false, ions = false;
};

}  // namespace alphascope::cli
