// SPDX-License-Identifier: GPL-3.0-or-later
// The options of molecules, files and cavities' bodies. Options of alpha and engines are in
// option_groups_engine.cpp.
#include "app/cli/option_groups.hpp"

#include <stdexcept>
#include <utility>

#include "app/options/fetch_flags.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/radii/radii_set.hpp"
#include "core/read/file_format.hpp"

namespace alphascope::cli {

void append(Options& options, Options more) {
  for (Option& option : more) options.push_back(std::move(option));
}

std::string radii_choices() {
  std::string text = "auto";
  for (const RadiiSetInfo& set : all_radii_sets()) {
    if (set.set != RadiiSet::user && set.id != "auto") text += "|" + std::string(set.id);
  }
  return text + "|FILE";
}

Options input_but_ligands(InputOptions& input) {
  const auto off = [](const char* name, const char* text, bool& value) {
    return flag_option(name, text, value);
  };
  return {
      choice_option({"--format", "auto|" + format_ids(),
                     "Format of the file; auto recognises it by content and name"},
                    input.format),
      text_option({"--radii", radii_choices(),
                   "Radii: a set, the file's own (file), or a FILE with a table of your own"},
                  input.radii),
      text_option({"--model", "N|all|joined",
                   "Model, counted from 1; all takes each by itself, joined takes all as one"},
                  input.model),
      choice_option({"--hydrogens", "auto|keep|drop",
                     "Hydrogens; auto drops them when the radii set includes them in heavy atoms"},
                    input.hydrogens),
      choice_option({"--altlocs", "best|all",
                     "Alternative locations: keep the best one in each residue, or all"},
                    input.altlocs),
      // The value "" means the chain without a name.
      may_be_empty(
          texts_option({"--chain", "ID", "Keep only these chains, such as A,B"}, input.chains)),
      may_be_empty(
          texts_option({"--without-chain", "ID", "Drop these chains"}, input.without_chains)),
      text_option({"--select", "EXPRESSION",
                   "Keep only atoms that match, such as \"chain A and not resn HEM\""},
                  input.select),
      texts_option({"--treat", "RESIDUES=KIND",
                    "Set kinds of residues, such as \"A:PU8 301=ligand\" or LIG=polymer: "
                    "polymer, ligand, ion, water or dummy"},
                   input.treated),
      text_option({"--assembly", "ID", "Expand a biological assembly; info lists them"},
                  input.assembly),
      flag_option("--waters", "Keep waters (dropped by default)", input.waters),
      flag_option("--dummies",
                  "Keep dummy atoms, such as OPM's membrane planes (dropped by default)",
                  input.dummies),
      off("--no-polymers", "Drop proteins and nucleic acids (kept by default)", input.no_polymers),
      offline_option(input.offline),
      fetch_again_option(input.fetch_again),
  };
}

std::string file_text() {
  return "Molecule: " + format_names() +
         "; also packed as .gz; - for standard input; or an id that is fetched: pdb:1CRN, "
         "af:P69905";
}

Option one_file(InputOptions& input, bool must_be) {
  const Option file = path_option({"FILE", "FILE", file_text()}, input.file);
  return must_be ? required(file) : file;
}

Options many_files(InputFiles& files) {
  Option named = texts_option({"FILE", "FILE", file_text()}, files.named);
  return {named,
          text_option({"--files-from", "LIST",
                       "Read file names from LIST, one per line; - for standard input"},
                      files.list),
          flag_option("--null", "Names in LIST end with a NUL byte, as find -print0 writes them",
                      files.null_separated)};
}

void require_files(const InputFiles& files) {
  if (files.named.empty() && files.list.empty()) {
    throw std::invalid_argument("name a FILE, or a list of files with --files-from");
  }
  if (files.null_separated && files.list.empty()) {
    throw std::invalid_argument("--null needs --files-from");
  }
}

Options tuple_work(TupleOptions& tuples) {
  Option grid{
      .names = "--tuple-grid",
      .value = "auto|100",
      .text = "Cells of the grid: a size suited to the molecule (auto), or 100 x 100 x 100 cells",
      .fallback = "auto"};
  grid.set = [&tuples, choices = grid.choices()](const std::string& id) {
    require_choice(id, choices);
    tuples.grid = id == "100" ? TupleGridKind::thesis : TupleGridKind::automatic;
  };
  return {
      grid,
      flag_option("--no-edge-optimisation", "Also enumerate tuples of balls that do not all meet",
                  tuples.edge_optimisation, false),
      flag_option("--no-alpha-optimisation",
                  "Also send tuples with an ortho-radius above alpha to kernel II",
                  tuples.alpha_optimisation, false)};
}

Option output(const char* name, const char* text, std::string& path) {
  return text_option({name, "OUT", text}, path);
}

Options input(InputOptions& input) {
  Options options = input_but_ligands(input);
  options.push_back(
      flag_option("--no-ligands", "Drop ligands (kept by default)", input.no_ligands));
  options.push_back(flag_option("--no-ions", "Drop ions (kept by default)", input.no_ions));
  return options;
}

Options body(InputOptions& input, BodyOptions& body) {
  Options options = input_but_ligands(input);
  for (Option& option : options) {
    if (option.names == "--radii") option.fallback = "the file's own, else castp";
  }
  append(options, {flag_option("--ligands", "Add ligands to the body", body.ligands),
                   flag_option("--ions", "Add ions to the body", body.ions)});
  return options;
}

}  // namespace alphascope::cli
