// alphascope-cli measure: exact area and volume of the union of balls of each file, or of each of
// its models: in all, and by atom, residue or chain.
#include <chrono>
#include <iostream>
#include <map>

#include "app/cli/commands.hpp"
#include "app/cli/files_command.hpp"
#include "app/cli/report_json.hpp"
#include "app/cli/terminal.hpp"
#include "app/cli/text.hpp"
#include "app/session/rounding_note.hpp"
#include "core/measure/union_measures.hpp"
#include "core/molecule/atom_address.hpp"

namespace alphascope::cli {
namespace {

struct Answer {
  EngineAnswer complex;
  UnionMeasures measures;
  Components components;
  double milliseconds = 0;  // of the measures alone
};

// Names of atoms, residues or chains, and which of them each ball belongs to.
struct Groups {
  std::vector<std::string> names;
  std::vector<std::uint32_t> of_ball;
};

std::string group_name(const Input& input, MeasuredBy by, std::size_t ball) {
  const std::size_t atom = input.prepared().atom_of_ball[ball];
  const Molecule& molecule = input.molecule();
  if (by == MeasuredBy::atom) return atom_address(molecule, atom);
  if (by == MeasuredBy::residue) return residue_address(molecule, atom);
  return std::string(molecule.text(molecule.atoms[atom].chain));
}

// In the order of the molecule. Atoms that share an address, as in files that run out of numbers,
// are one group only when they are neighbours in the file; every atom is one by itself.
Groups groups_of(const Input& input, MeasuredBy by) {
  Groups groups;
  const std::size_t balls = input.prepared().balls->size();
  std::map<std::string, std::uint32_t> chains;
  for (std::size_t ball = 0; ball < balls; ++ball) {
    std::string name = group_name(input, by, ball);
    if (by == MeasuredBy::chain) {
      const auto [at, added] = chains.try_emplace(name, groups.names.size());
      if (added) groups.names.push_back(name);
      groups.of_ball.push_back(at->second);
      continue;
    }
    const bool same =
        by == MeasuredBy::residue && !groups.names.empty() && groups.names.back() == name;
    if (!same) groups.names.push_back(std::move(name));
    groups.of_ball.push_back(static_cast<std::uint32_t>(groups.names.size() - 1));
  }
  return groups;
}

Answer measure(const Input& input, const MeasureCommandOptions& options, EngineCache& engines,
               const RunContext& context) {
  Answer answer;
  answer.complex = engines.compute(input.prepared().balls, options.request, context);
  const auto start = std::chrono::steady_clock::now();
  answer.measures = measure_union(*answer.complex.balls, answer.complex.complex,
                                  {.threads = options.request.threads}, context);
  answer.components = components(answer.complex.balls->size(), answer.complex.complex);
  answer.milliseconds =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return answer;
}

void print(const Input& input, const MeasureCommandOptions& options, const Answer& answer) {
  const Request& request = options.request;
  const bool quiet = verbosity() == Verbosity::quiet;
  std::cout << input_text(input) << "sha256      " << input.molecule().sha256 << "\n"
            << "alpha       " << number_text(request.alpha_angstrom2) << " Å², solvent radius "
            << number_text(request.solvent_radius_angstrom) << " Å\n"
            << "area        " << format_text("%.6f", answer.measures.area_angstrom2) << " Å²\n"
            << "volume      " << format_text("%.6f", answer.measures.volume_angstrom3) << " Å³\n"
            << "components  " << grouped(answer.components.count) << "\n"
            << "hash        " << hash_text(answer.complex.complex.hash) << "\n";
  if (!quiet) {
    if (!answer.complex.note.empty()) std::cout << "note        " << answer.complex.note << "\n";
    std::cout << "time        complex "
              << milliseconds_text(answer.complex.complex.timings.wall_milliseconds) << " ("
              << answer.complex.complex.engine.name << ", " << answer.complex.complex.engine.device
              << "), measures " << milliseconds_text(answer.milliseconds) << "\n";
  }
  std::cout << std::flush;
}

CsvRow csv_row(const Input& input, const Request& request, const Answer& answer,
               const std::string& group, double area, double volume) {
  CsvRow row{{"model", model_text(input.balls.model)},
             {"group", group},
             {"area_angstrom2", all_digits(area)},
             {"volume_angstrom3", all_digits(volume)},
             {"alpha_angstrom2", number_text(request.alpha_angstrom2)},
             {"solvent_radius_angstrom", number_text(request.solvent_radius_angstrom)},
             {"hash", hash_text(answer.complex.complex.hash)}};
  for (auto& [key, value] : input.provenance()) {
    if (key != "model") row.emplace_back(key, std::move(value));
  }
  row.emplace_back("program", program_text());
  return row;
}

// The groups' values, or one row for all.
template <class Use>
void for_each_group(const Input& input, MeasuredBy by, const Answer& answer, const Use& use) {
  const UnionMeasures& m = answer.measures;
  if (by == MeasuredBy::total) return use("", m.area_angstrom2, m.volume_angstrom3);
  const Groups groups = groups_of(input, by);
  const std::vector<double> areas = sums_by_group(m.ball_area_angstrom2, groups.of_ball,
                                                  groups.names.size()),
                            volumes = sums_by_group(m.ball_volume_angstrom3, groups.of_ball,
                                                    groups.names.size());
  for (std::size_t g = 0; g < groups.names.size(); ++g) use(groups.names[g], areas[g], volumes[g]);
}

Json result_json(const Input& input, const MeasureCommandOptions& options, const Answer& answer) {
  Json groups = Json::array();
  if (options.by != MeasuredBy::total) {
    for_each_group(input, options.by, answer,
                   [&](const std::string& name, double area, double volume) {
                     groups.push_back(
                         {{"group", name}, {"area_angstrom2", area}, {"volume_angstrom3", volume}});
                   });
  }
  Json json = complex_json(answer.complex.complex, answer.complex.note);
  json["measures"] = {{"area_angstrom2", answer.measures.area_angstrom2},
                      {"volume_angstrom3", answer.measures.volume_angstrom3},
                      {"components", answer.components.count},
                      {"groups", groups},
                      {"ms", answer.milliseconds}};
  json["request"] = request_json(options.request, answer.complex.balls->lattice);
  json["input"] = input_json(input);
  return json;
}

}  // namespace

ExitCode run_measure(const MeasureCommandOptions& options) {
  const RunContext& context = run_context();
  FilesCommand command(options.files, options.input, open_options(options.input, context),
                       {options.json, options.csv});
  EngineCache engines(&make_engine);
  return command.run([&](const std::string&, const Input& input) {
    const Answer answer = measure(input, options, engines, context);
    clear_progress();
    if (command.shown()) print(input, options, answer);
    if (command.json.wanted()) command.json.add(result_json(input, options, answer));
    if (!command.csv.wanted()) return;
    for_each_group(input, options.by, answer,
                   [&](const std::string& name, double area, double volume) {
                     command.csv.add(csv_row(input, options.request, answer, name, area, volume));
                   });
  });
}

}  // namespace alphascope::cli
