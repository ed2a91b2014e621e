// SPDX-License-Identifier: GPL-3.0-or-later
// Runs alphascope-cli info: prints the contents of files, and the atoms that would be used.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "app/cli/command.hpp"
#include "app/cli/commands/columns.hpp"
#include "app/cli/commands/info_structure.hpp"
#include "app/cli/failure.hpp"
#include "app/cli/files_command.hpp"
#include "app/cli/option_groups.hpp"
#include "app/cli/report_json.hpp"
#include "app/cli/text/table.hpp"
#include "app/cli/text/terminal.hpp"
#include "app/cli/text/text.hpp"
#include "app/options/option_values.hpp"
#include "core/files/fetched_file.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/molecule/assembly.hpp"
#include "core/radii/radii_set.hpp"
#include "core/selection/residue_list.hpp"
#include "core/selection/treatments.hpp"
#include "core/text/grouped_number.hpp"
#include "core/text/printable.hpp"

namespace alphascope::cli {
namespace {

struct InfoOptions {
  InputFiles files;
  InputOptions input;
  // Paths; "-" is standard output, empty is none.
  std::string json, csv;
  bool residues = false, each_residue = false;
};

constexpr std::size_t kShownGuesses = 8;

struct Extent {
  double min = 0, max = 0;  // Å
};

Extent extent(const BallSet& balls, std::int32_t LatticePoint::*axis) {
  if (balls.size() == 0) return {};
  std::int32_t low = balls.centres[0].*axis, high = low;
  for (const LatticePoint& p : balls.centres) {
    low = std::min(low, p.*axis);
    high = std::max(high, p.*axis);
  }
  return {balls.lattice.angstrom(low), balls.lattice.angstrom(high)};
}

Json radii_json(const BallSet& balls) {
  std::map<std::int32_t, std::size_t> histogram;
  for (const std::int32_t radius : balls.radii) ++histogram[radius];
  Json json = Json::array();
  for (const auto& [radius, count] : histogram) {
    json.push_back({{"radius_angstrom", balls.lattice.angstrom(radius)}, {"balls", count}});
  }
  return json;
}

// Number of atoms of each kind, over all models.
Json kinds_json(const MoleculeContents& contents) {
  Json json = Json::object();
  for (std::size_t k = 0; k < contents.kinds.size(); ++k) {
    json[kind_name(static_cast<ResidueKind>(k))] = contents.kinds[k];
  }
  return json;
}

void print_guesses(std::vector<GuessedRadius> guesses) {
  // Guesses from sources outside the radii set come first. They matter more than the usual carbon
  // radius for a ligand.
  std::stable_partition(guesses.begin(), guesses.end(), [](const GuessedRadius& guess) {
    return guess.source != kTypicalValueSource;
  });
  for (std::size_t i = 0; i < std::min(kShownGuesses, guesses.size()); ++i) {
    const GuessedRadius& guess = guesses[i];
    std::cout << "  guessed   " << guess.atoms << ": " << shortest_number(guess.radius_angstrom)
              << " Å for " << grouped(guess.count) << (guess.count == 1 ? " atom" : " atoms")
              << " (" << guess.source << ")\n";
  }
  if (guesses.size() > kShownGuesses) {
    std::cout << "  guessed   … and " << grouped(guesses.size() - kShownGuesses)
              << " more kinds of atoms; --json lists all\n";
  }
}

// Prints atoms and memory of each assembly only if the molecule is the deposited one. They would be
// wrong for copies of an expanded one.
void print_assemblies(const Molecule& molecule) {
  for (const AssemblyInfo& assembly : list_assemblies(molecule)) {
    std::cout << "assembly    --assembly " << assembly.id << ": " << grouped(assembly.copies)
              << (assembly.copies == 1 ? " operator" : " operators");
    if (molecule.assembly_id.empty()) {
      std::cout << ", " << counted(assembly.atoms, "atom", "atoms") << ", about "
                << grouped(assembly.memory_bytes >> 20) << " MiB";
    }
    std::cout << (assembly.id == molecule.assembly_id ? ", expanded here" : "")
              << (assembly.details.empty() ? "" : " (" + assembly.details + ")") << "\n";
  }
}

// Writes a length with two digits, rounded up, since it bounds the rounding.
std::string rounding_text(double angstrom) {
  const double unit = std::pow(10, std::floor(std::log10(angstrom)) - 1);
  return shortest_number(std::ceil(angstrom / unit) / std::round(1 / unit));
}

std::string lattice_rounding_text(const Molecule& molecule, const SelectionReport& report) {
  std::string text;
  if (molecule.rounding_angstrom > 0) {
    text = "coordinates rounded by up to " + rounding_text(molecule.rounding_angstrom) + " Å";
  }
  if (report.radius_rounding_angstrom > 0) {
    text += (text.empty() ? "" : ", ") +
            ("radii rounded by up to " + rounding_text(report.radius_rounding_angstrom)) + " Å";
  }
  return text.empty() ? "nothing was rounded" : text;
}

void print(const Input& input) {
  const Molecule& molecule = input.molecule();
  const BallSet& balls = *input.prepared().balls;
  const SelectionReport& report = input.prepared().report;
  std::cout << input_text(input);
  std::cout << "format      " << molecule.format << "\n";
  if (!molecule.title.empty()) std::cout << "title       " << molecule.title << "\n";
  std::cout << "atoms       " << grouped(molecule.atoms.size()) << " in "
            << grouped(molecule.models.size())
            << (molecule.models.size() == 1 ? " model\n" : " models\n");
  std::cout << "kinds       " << kinds_text(input.opened.contents->kinds) << "\n";
  std::cout << structure_text(input);
  print_assemblies(molecule);
  std::cout << "balls       " << grouped(balls.size()) << "\n";
  std::cout << "radii       " << report.radii_name;
  if (!report.radii_citation.empty()) std::cout << ": " << report.radii_citation;
  std::cout << "\n";
  print_guesses(report.guessed);
  std::cout << "lattice     " << shortest_number(balls.lattice.unit_angstrom()) << " Å; "
            << lattice_rounding_text(molecule, report) << "\n";
  if (report.coincident_centres > 0) {
    std::cout << "coincident  "
              << counted(report.coincident_centres, "ball shares its", "balls share their")
              << " centre with an earlier ball\n";
  }
  const char* names[] = {"x", "y", "z"};
  std::int32_t LatticePoint::*axes[] = {&LatticePoint::x, &LatticePoint::y, &LatticePoint::z};
  for (int axis = 0; axis < 3; ++axis) {
    const Extent range = extent(balls, axes[axis]);
    std::cout << names[axis] << "           " << shortest_number(range.min) << " to "
              << shortest_number(range.max) << " Å\n";
  }
  if (const auto from = fetched_from(molecule.source)) {
    std::cout << "fetched     " << printable(from->text()) << "\n";
  }
  std::cout << "sha256      " << molecule.sha256 << "\n";
  if (times_shown()) {
    std::cout << "opened in   " << milliseconds_text(input.open_milliseconds) << "\n";
  }
}

ResidueListing listing_of(const InfoOptions& options) {
  return options.each_residue ? ResidueListing::each : ResidueListing::grouped;
}

// The residues of the chosen model.
std::vector<ListedResidues> residues_of(const Input& input, ResidueListing listing) {
  const Molecule& molecule = input.molecule();
  if (input.balls.model == kAllModels) {
    return list_residues(molecule, 0, molecule.atoms.size(), listing);
  }
  const ModelRange& model = molecule.models[static_cast<std::size_t>(input.balls.model)];
  return list_residues(molecule, model.begin, model.end, listing);
}

// `secondary`: the kinds of residues that are listed one by one; null for groups of residues.
void print_residues(const std::vector<ListedResidues>& list, const SecondaryKinds* secondary) {
  std::vector<std::string> names, numbers;
  for (const ListedResidues& residues : list) {
    names.push_back(residues.name);
    numbers.push_back(residues.number);
  }
  std::vector<TableColumn> columns{{"chain", 5, true},
                                   {"name", widest(names), true},
                                   {"number", widest(numbers), true},
                                   {"kind", 7, true},
                                   {"residues", 8},
                                   {"atoms", 9}};
  if (secondary != nullptr) columns.push_back({"secondary", 15, true});
  columns.push_back({"why", 0, true});
  const Table table(columns);
  std::cout << table.heading();
  for (const ListedResidues& residues : list) {
    std::vector<std::string> line{residues.chain,
                                  residues.name,
                                  residues.number,
                                  kind_name(residues.kind),
                                  grouped(residues.residues),
                                  grouped(residues.atoms)};
    if (secondary != nullptr) line.push_back(secondary_of(*secondary, residues));
    line.emplace_back(reason_text(residues.why));
    std::cout << table.line(line);
  }
}

Json residues_json(const std::vector<ListedResidues>& list, const SecondaryKinds* secondary) {
  Json json = Json::array();
  for (const ListedResidues& residues : list) {
    json.push_back({{"chain", residues.chain},
                    {"name", residues.name},
                    {"number", residues.number},
                    {"kind", kind_name(residues.kind)},
                    {"why", reason_id(residues.why)},
                    {"text", reason_text(residues.why)},
                    {"guessed", is_guess(residues.why)},
                    {"residues", residues.residues},
                    {"atoms", residues.atoms}});
    const std::string kind = secondary ? secondary_of(*secondary, residues) : std::string();
    if (!kind.empty()) json.back()["secondary_structure"] = kind;
  }
  return json;
}

Table info_table(const std::vector<std::string>& files, bool models) {
  std::vector<TableColumn> columns{{"file", widest(files), true}, {"format", 6, true}};
  columns.push_back({models ? "model" : "models", 6});
  for (const char* count : {"atoms", "balls", "guessed"}) columns.push_back({count, 9});
  columns.push_back({"radii", 0, true});
  return Table(columns);
}

// A line of the table. `models`: each model has a line.
std::string table_line(const Table& table, const std::string& file, const Input& input,
                       bool models) {
  const Molecule& molecule = input.molecule();
  const SelectionReport& report = input.prepared().report;
  return table.line({file, molecule.format,
                     models ? model_text(input.balls.model) : grouped(molecule.models.size()),
                     grouped(report.total), grouped(report.used), grouped(report.guessed_atoms),
                     report.radii_name});
}

const Column<Input> kColumns[] = {
    {.id = "file",
     .title = "file",
     .help = "The file as it was named.",
     .value = [](const Input& r) -> CellValue { return printable(r.molecule().source.string()); },
     .files = InFiles::csv},
    {.id = "model",
     .title = "model",
     .help = "The model of the file, from 1; “joined” for all models as one.",
     .value = [](const Input& r) -> CellValue { return model_text(r.balls.model); },
     .files = InFiles::csv},
    {.id = "models",
     .title = "models",
     .help = "The number of models in the file.",
     .value = [](const Input& r) -> CellValue {
       return static_cast<std::uint64_t>(r.molecule().models.size());
     },
     .files = InFiles::csv},
    {.id = "atoms",
     .title = "atoms",
     .help = "The number of atoms of the model.",
     .value = [](const Input& r) -> CellValue {
       return static_cast<std::uint64_t>(r.prepared().report.total);
     },
     .files = InFiles::csv},
    {.id = "balls",
     .title = "balls",
     .help = "The number of atoms that are used.",
     .value = [](const Input& r) -> CellValue {
       return static_cast<std::uint64_t>(r.prepared().balls->size());
     },
     .files = InFiles::csv},
    {.id = "guessed_atoms",
     .title = "guessed",
     .help = "The number of atoms whose radius was guessed.",
     .value = [](const Input& r) -> CellValue {
       return static_cast<std::uint64_t>(r.prepared().report.guessed_atoms);
     },
     .files = InFiles::csv},
    {.id = "coincident_centres",
     .title = "coincident",
     .help = "The number of balls at the place of another one.",
     .value = [](const Input& r) -> CellValue {
       return static_cast<std::uint64_t>(r.prepared().report.coincident_centres);
     },
     .files = InFiles::csv},
    {.id = "title",
     .title = "title",
     .help = "The title in the file.",
     .value = [](const Input& r) -> CellValue { return r.molecule().title; },
     .files = InFiles::csv}};
constexpr std::span<const Column<Input>> kAllColumns(kColumns);

CsvRow csv_row(const Input& input) {
  CsvRow row = csv_row_of(kAllColumns, input);
  for (auto& [key, value] : input.provenance()) {
    if (key != "model" && key != "file") row.emplace_back(key, std::move(value));
  }
  row.emplace_back("program", program_text());
  return row;
}

ExitCode run_info(const InfoOptions& options) {
  const RunContext& context = run_context();
  FilesCommand command(options.files, options.input, open_options(options.input, context),
                       {options.json, options.csv});
  const bool many = command.many, each = command.each_model, shown = command.shown();
  const bool listed = options.residues || options.each_residue;
  const Table table = info_table(command.files, each);
  if (shown && many) std::cout << table.heading();
  return command.run([&](const std::string& file, const Input& input) {
    clear_progress();
    if (shown && many) {
      if (verbosity() != Verbosity::quiet) {
        for (const std::string& note : input_notes(input)) print_error(file + ": note: " + note);
      }
      std::cout << table_line(table, file, input, each) << std::flush;
    } else if (shown) {
      if (!each || input.balls.model == 0) print(input);
      if (each) {
        std::cout << "model " << model_text(input.balls.model) << ": "
                  << summary(input.prepared().report) << "\n";
      }
    }
    std::vector<ListedResidues> residues;
    if (listed) residues = residues_of(input, listing_of(options));
    std::vector<SecondaryModel> secondary;
    if (options.each_residue || command.json.wanted()) secondary = secondary_of(input);
    const SecondaryKinds kinds = options.each_residue ? kinds_by_atom(secondary) : SecondaryKinds();
    const SecondaryKinds* const shown_kinds = options.each_residue ? &kinds : nullptr;
    if (listed && shown) print_residues(residues, shown_kinds);
    if (command.json.wanted()) {
      Json json = {{"input", input_json(input, input.prepared().balls->lattice)},
                   {"kinds", kinds_json(*input.opened.contents)},
                   {"radii_in_use", radii_json(*input.prepared().balls)}};
      add_structure_json(input, secondary, json);
      if (listed) json["residues"] = residues_json(residues, shown_kinds);
      command.json.add(std::move(json));
    }
    if (command.csv.wanted()) command.csv.add(csv_row(input));
  });
}

OptionCommand table_of_info(InfoOptions& options) {
  OptionCommand command{"info", "Report what files contain and which atoms are used", {}};
  command.options = many_files(options.files);
  append(command.options, input(options.input));
  command.options.push_back(flag_option(
      "--residues", "List the kinds of residues, and the reasons for them", options.residues));
  command.options.push_back(flag_option(
      "--each-residue",
      "List the kind and the secondary structure of every residue on a line of its own, and the "
      "reason for the kind",
      options.each_residue));
  command.options.push_back(output(
      "--json", "Contents, used atoms and radii as JSON; - for standard output", options.json));
  command.options.push_back(
      output("--csv", "One row for each file and model; - for standard output", options.csv));
  command.check = [&options] { require_files(options.files); };
  return command;
}

}  // namespace

std::vector<ColumnInfo> info_columns() {
  return infos_of(kAllColumns);
}

Command info_command() {
  return make_command<InfoOptions>(
      table_of_info, run_info,
      {"alphascope-cli info 1crn.pdb",
       "find pdb -name '*.cif.gz' | alphascope-cli info --files-from - --csv -"});
}

}  // namespace alphascope::cli
