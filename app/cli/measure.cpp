// alphascope-cli measure: exact area and volume of the union of balls of each file, or of each of
// its models: in all, of each component, and by atom, residue or chain.
#include <algorithm>
#include <iostream>

#include "app/cli/commands.hpp"
#include "app/cli/files_command.hpp"
#include "app/cli/report_json.hpp"
#include "app/cli/terminal.hpp"
#include "app/cli/text.hpp"
#include "app/session/rounding_note.hpp"
#include "core/document/measure_names.hpp"
#include "core/measure/union_measures.hpp"
#include "core/molecule/atom_address.hpp"
#include "core/molecule/atom_groups.hpp"

namespace alphascope::cli {
namespace {

struct Answer {
  EngineAnswer complex;
  UnionMeasures measures;
  UnionDerivatives derivatives;  // empty unless asked for
  Components components;
  double milliseconds = 0;  // of the measures alone
};

Answer measure(const Input& input, const MeasureCommandOptions& options, EngineCache& engines,
               const RunContext& context) {
  Answer answer;
  answer.complex = engines.compute(input.prepared().balls, options.request, context);
  const BallSet& balls = *answer.complex.balls;
  answer.milliseconds = timed([&] {
    answer.measures = measure_union(
        balls, answer.complex.complex,
        {options.request.threads, options.derivatives ? &answer.derivatives : nullptr}, context);
  });
  answer.components = components(balls.size(), answer.complex.complex);
  return answer;
}

// --- atoms, residues, chains, components and all

// A number and the name that CSV and JSON give it.
struct Value {
  std::string name;
  double value;
};

// What there is of each group, in the order of the groups.
struct Table {
  std::vector<std::string> names;
  std::vector<std::size_t> atoms;
  std::vector<std::vector<Value>> values;
};

std::vector<Value> derivatives_of(const UnionDerivatives& d, std::size_t ball) {
  const Gradient &area = d.area_by_centre_angstrom[ball],
                 &volume = d.volume_by_centre_angstrom2[ball];
  return {{"area_by_x_angstrom", area.x},
          {"area_by_y_angstrom", area.y},
          {"area_by_z_angstrom", area.z},
          {"area_by_radius_angstrom", d.area_by_radius_angstrom[ball]},
          {"volume_by_x_angstrom2", volume.x},
          {"volume_by_y_angstrom2", volume.y},
          {"volume_by_z_angstrom2", volume.z},
          {"volume_by_radius_angstrom2", d.volume_by_radius_angstrom2[ball]}};
}

double share(double part, double whole) {
  return whole > 0 ? part / whole : 0;
}

// Of groups of balls; kNoGroup belongs to none.
Table table_of(const Answer& answer, const std::vector<std::uint32_t>& group,
               std::vector<std::string> names) {
  const UnionMeasures& m = answer.measures;
  const std::size_t groups = names.size();
  const auto sums = [&](const std::vector<double>& values) {
    return sums_by_group(values, group, groups);
  };
  const std::vector<double> areas = sums(m.ball_area_angstrom2),
                            volumes = sums(m.ball_volume_angstrom3),
                            free = sums(free_areas_angstrom2(
                                *answer.complex.balls, answer.complex.complex.alpha_on_lattice));
  Table table{std::move(names), std::vector<std::size_t>(groups), {}};
  for (const std::uint32_t g : group) {
    if (g != kNoGroup) ++table.atoms[g];
  }
  for (std::size_t g = 0; g < groups; ++g) {
    table.values.push_back({{"area_angstrom2", areas[g]},
                            {"volume_angstrom3", volumes[g]},
                            {"exposed_share", share(areas[g], free[g])},
                            {"share_of_area", share(areas[g], m.area_angstrom2)},
                            {"share_of_volume", share(volumes[g], m.volume_angstrom3)}});
  }
  return table;
}

// Components have the name of their first atom.
Table component_table(const Input& input, const Answer& answer) {
  std::vector<std::string> names;
  for (std::size_t ball = 0; ball < answer.components.of_ball.size(); ++ball) {
    if (answer.components.of_ball[ball] != names.size()) continue;
    names.push_back(atom_address(input.molecule(), input.prepared().atom_of_ball[ball]));
  }
  return table_of(answer, answer.components.of_ball, std::move(names));
}

Table table_per(const Input& input, MeasuredPer per, const Answer& answer) {
  if (per == MeasuredPer::component) return component_table(input, answer);
  const auto& atom_of_ball = input.prepared().atom_of_ball;
  if (per == MeasuredPer::all) {
    return table_of(answer, std::vector<std::uint32_t>(atom_of_ball.size(), 0), {""});
  }
  const AtomGrouping by = per == MeasuredPer::atom      ? AtomGrouping::atom
                          : per == MeasuredPer::residue ? AtomGrouping::residue
                                                        : AtomGrouping::chain;
  const AtomGroups groups = atom_groups(input.molecule(), atom_of_ball, by);
  std::vector<std::string> names;
  for (const std::uint32_t atom : groups.first) {
    names.push_back(group_name(input.molecule(), atom, by));
  }
  Table table = table_of(answer, groups.of_ball, std::move(names));
  if (answer.derivatives.area_by_radius_angstrom.empty()) return table;
  for (std::size_t ball = 0; ball < table.values.size(); ++ball) {  // each is a group
    const std::vector<Value> more = derivatives_of(answer.derivatives, ball);
    table.values[ball].insert(table.values[ball].end(), more.begin(), more.end());
  }
  return table;
}

// --- output

std::string components_text(const Answer& answer) {
  const Components& of = answer.components;
  std::string text = grouped(of.count);
  if (of.count < 2) return text;
  const auto volumes = sums_by_group(answer.measures.ball_volume_angstrom3, of.of_ball, of.count);
  const double largest = *std::max_element(volumes.begin(), volumes.end());
  return text + format_text("; the largest has %.2f %% of the volume",
                            100 * share(largest, answer.measures.volume_angstrom3));
}

void print(const Input& input, const MeasureCommandOptions& options, const Answer& answer) {
  const Request& request = options.request;
  const AlphaComplex& complex = answer.complex.complex;
  std::cout << input_text(input) << "sha256      " << input.molecule().sha256 << "\n"
            << "alpha       " << number_text(request.alpha_angstrom2) << " Å², solvent radius "
            << number_text(request.solvent_radius_angstrom) << " Å\n"
            << "surface     " << surface_name(request) << "\n"
            << "area        " << format_text("%.6f", answer.measures.area_angstrom2) << " Å²\n"
            << "volume      " << format_text("%.6f", answer.measures.volume_angstrom3) << " Å³\n"
            << "components  " << components_text(answer) << "\n"
            << "hash        " << hash_text(complex.hash) << "\n";
  if (verbosity() != Verbosity::quiet) {
    if (!answer.complex.note.empty()) std::cout << "note        " << answer.complex.note << "\n";
    std::cout << "time        complex " << milliseconds_text(complex.timings.wall_milliseconds)
              << " (" << complex.engine.name << ", " << complex.engine.device << "), measures "
              << milliseconds_text(answer.milliseconds) << "\n";
  }
  std::cout << std::flush;
}

void add_rows(CsvResults& csv, const Input& input, const Request& request, const Answer& answer,
              const Table& table) {
  const Provenance provenance = input.provenance();
  for (std::size_t g = 0; g < table.names.size(); ++g) {
    CsvRow row{{"model", model_text(input.balls.model)},
               {"group", table.names[g]},
               {"atoms", std::to_string(table.atoms[g])}};
    for (const Value& v : table.values[g]) row.emplace_back(v.name, all_digits(v.value));
    row.emplace_back("surface", surface_name(request));
    row.emplace_back("alpha_angstrom2", number_text(request.alpha_angstrom2));
    row.emplace_back("solvent_radius_angstrom", number_text(request.solvent_radius_angstrom));
    row.emplace_back("hash", hash_text(answer.complex.complex.hash));
    for (const auto& [key, value] : provenance) {
      if (key != "model") row.emplace_back(key, value);
    }
    row.emplace_back("program", program_text());
    csv.add(row);
  }
}

Json json_of(const Table& table) {
  Json groups = Json::array();
  for (std::size_t g = 0; g < table.names.size(); ++g) {
    Json group{{"name", table.names[g]}, {"atoms", table.atoms[g]}};
    for (const Value& v : table.values[g]) group[v.name] = v.value;
    groups.push_back(std::move(group));
  }
  return groups;
}

Json result_json(const Input& input, const MeasureCommandOptions& options, const Answer& answer,
                 const Table& table) {
  Json json{{"surface", surface_name(options.request)},
            {"area_angstrom2", answer.measures.area_angstrom2},
            {"volume_angstrom3", answer.measures.volume_angstrom3},
            {"components", json_of(component_table(input, answer))}};
  if (options.per == MeasuredPer::atom) json["atoms"] = json_of(table);
  if (options.per == MeasuredPer::residue) json["residues"] = json_of(table);
  if (options.per == MeasuredPer::chain) json["chains"] = json_of(table);
  json["measures_ms"] = answer.milliseconds;
  json.update(complex_json(answer.complex.complex, answer.complex.note));
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
    const bool tabled = command.json.wanted() || command.csv.wanted();
    const Table table = tabled ? table_per(input, options.per, answer) : Table{};
    clear_progress();
    if (command.shown()) print(input, options, answer);
    if (command.json.wanted()) command.json.add(result_json(input, options, answer, table));
    if (command.csv.wanted()) add_rows(command.csv, input, options.request, answer, table);
  });
}

}  // namespace alphascope::cli
