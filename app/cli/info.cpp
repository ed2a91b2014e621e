// alphascope-cli info: what is in files, and what would be used of them.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>

#include "app/cli/commands.hpp"
#include "app/cli/failure.hpp"
#include "app/cli/files_command.hpp"
#include "app/cli/report_json.hpp"
#include "app/cli/table.hpp"
#include "app/cli/terminal.hpp"
#include "app/cli/text.hpp"
#include "core/molecule/assembly.hpp"
#include "core/molecule/printable.hpp"

namespace alphascope::cli {
namespace {

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

void print_guesses(std::vector<GuessedRadius> guesses) {
  // What comes from outside of the set says more than that a ligand's carbon is a carbon.
  std::stable_partition(guesses.begin(), guesses.end(), [](const GuessedRadius& guess) {
    return guess.source != kTypicalOfTheSet;
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

// Atoms and memory are those of copying this molecule, so they are only said of a deposited one.
void print_assemblies(const Molecule& molecule) {
  for (const AssemblyInfo& assembly : list_assemblies(molecule)) {
    std::cout << "assembly    --assembly " << assembly.id << ": " << grouped(assembly.copies)
              << (assembly.copies == 1 ? " operator" : " operators");
    if (molecule.assembly_id.empty()) {
      std::cout << ", " << grouped(assembly.atoms) << " atoms, about "
                << grouped(assembly.memory_bytes >> 20) << " MiB";
    }
    std::cout << (assembly.id == molecule.assembly_id ? ", expanded here" : "")
              << (assembly.details.empty() ? "" : " (" + assembly.details + ")") << "\n";
  }
}

// An upper bound on the rounding with two digits, for people.
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
  print_assemblies(molecule);
  std::cout << "balls       " << grouped(balls.size()) << "\n";
  std::cout << "radii       " << report.radii_name;
  if (!report.radii_citation.empty()) std::cout << ": " << report.radii_citation;
  std::cout << "\n";
  print_guesses(report.guessed);
  std::cout << "lattice     " << shortest_number(balls.lattice.unit_angstrom()) << " Å; "
            << lattice_rounding_text(molecule, report) << "\n";
  if (report.coincident_centres > 0) {
    std::cout << "coincident  " << grouped(report.coincident_centres)
              << " balls share their centre with an earlier one\n";
  }
  const char* names[] = {"x", "y", "z"};
  std::int32_t LatticePoint::*axes[] = {&LatticePoint::x, &LatticePoint::y, &LatticePoint::z};
  for (int axis = 0; axis < 3; ++axis) {
    const Extent range = extent(balls, axes[axis]);
    std::cout << names[axis] << "           " << shortest_number(range.min) << " to "
              << shortest_number(range.max) << " Å\n";
  }
  std::cout << "sha256      " << molecule.sha256 << "\n";
  if (times_shown()) {
    std::cout << "opened in   " << milliseconds_text(input.open_milliseconds) << "\n";
  }
}

Table info_table(const std::vector<std::string>& files, bool models) {
  std::vector<TableColumn> columns{{"file", widest(files), true}, {"format", 6, true}};
  columns.push_back({models ? "model" : "models", 6});
  for (const char* count : {"atoms", "balls", "guessed"}) columns.push_back({count, 9});
  columns.push_back({"radii", 0, true});
  return Table(columns);
}

// A line of the table: `models` when each model has one.
std::string table_line(const Table& table, const std::string& file, const Input& input,
                       bool models) {
  const Molecule& molecule = input.molecule();
  const SelectionReport& report = input.prepared().report;
  return table.line({file, molecule.format,
                     models ? model_text(input.balls.model) : grouped(molecule.models.size()),
                     grouped(report.total), grouped(report.used), grouped(report.guessed_atoms),
                     report.radii_name});
}

CsvRow csv_row(const Input& input) {
  const Molecule& molecule = input.molecule();
  const SelectionReport& report = input.prepared().report;
  CsvRow row{{"file", printable(molecule.source.string())},
             {"model", model_text(input.balls.model)},
             {"models", std::to_string(molecule.models.size())},
             {"atoms", std::to_string(report.total)},
             {"balls", std::to_string(input.prepared().balls->size())},
             {"guessed_atoms", std::to_string(report.guessed_atoms)},
             {"coincident_centres", std::to_string(report.coincident_centres)},
             {"title", molecule.title}};
  for (auto& [key, value] : input.provenance()) {
    if (key != "model" && key != "file") row.emplace_back(key, std::move(value));
  }
  row.emplace_back("program", program_text());
  return row;
}

}  // namespace

ExitCode run_info(const InfoOptions& options) {
  const RunContext& context = run_context();
  FilesCommand command(options.files, options.input, open_options(options.input, context),
                       {options.json, options.csv});
  const bool many = command.many, each = command.each_model, shown = command.shown();
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
    if (command.json.wanted()) {
      command.json.add({{"input", input_json(input, input.prepared().balls->lattice)},
                        {"radii_in_use", radii_json(*input.prepared().balls)}});
    }
    if (command.csv.wanted()) command.csv.add(csv_row(input));
  });
}

}  // namespace alphascope::cli
