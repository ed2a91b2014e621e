// What is read and which atoms of it become balls, as the command line says it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace alphascope::cli {

struct InputOptions {
  std::filesystem::path file;   // "-" for standard input
  std::string format = "auto";  // or an id of a format, as format_from_id() takes it
  std::string radii = "auto";   // id of a radii set, or a file with a table of radii
  std::string model = "1";      // counted from 1; "all": each by itself; "joined": all as one
  std::string hydrogens = "auto", altlocs = "best";
  bool waters = false, dummies = false, no_ligands = false, no_ions = false, no_polymers = false;
  std::vector<std::string> chains, without_chains, treated;
  std::string select;    // core/selection/selection_expression.hpp
  std::string assembly;  // id, empty = as deposited
};

inline bool each_model(const InputOptions& options) {
  return options.model == "all";
}

// The files of a command that takes many.
struct InputFiles {
  std::vector<std::string> named;
  std::string list;             // file with more names, "-" for standard input, empty for none
  bool null_separated = false;  // names in the list end with a NUL byte, not with the line
  // Then results are a table and go on after an error.
  bool many() const { return named.size() > 1 || !list.empty(); }
};

// What belongs to the body whose cavities are looked for, beside proteins and nucleic acids.
struct BodyOptions {
  bool ligands = false, ions = false;
};

}  // namespace alphascope::cli
