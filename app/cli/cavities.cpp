// alphascope-cli cavities: voids and pockets of each file, or of each of its models, as CASTp finds
// them, with their areas, volumes, mouths and lining residues.
#include <iostream>
#include <memory>

#include "app/cli/commands.hpp"
#include "app/cli/files_command.hpp"
#include "app/cli/report_json.hpp"
#include "app/cli/table.hpp"
#include "app/cli/terminal.hpp"
#include "app/cli/text.hpp"
#include "app/session/rounding_note.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/document/cavity_names.hpp"
#include "core/document/cavity_preset.hpp"
#include "core/run/stage_timer.hpp"
#include "core/run/work_threads.hpp"
#include "core/triangulation/cgal_triangulation.hpp"

namespace alphascope::cli {
namespace {

struct Answer {
  CavityTable table;
  std::vector<ClippedMeasures> exact;  // of table.found.cavities
  StageTimes times;
  std::vector<std::string> differences;  // from what CASTp takes
  std::string device;                    // "CPU, 2 threads"
};

Answer find(const Input& input, const CavitiesOptions& options, const RunContext& context) {
  const Request& request = options.request;
  Answer answer;
  answer.differences = differences_from_castp(input.balls, input.prepared().report.radii, request);
  if (options.rule == OutsideRule::pocket)
    answer.differences.push_back("Pocket's rule of what is outside");
  if (options.ties == FlowTies::strict) answer.differences.push_back("ties do not flow");
  const auto balls = std::make_shared<const BallSet>(
      with_solvent(*input.prepared().balls, request.solvent_radius_angstrom));
  WorkThreads threads(request.threads);
  answer.device = threads.text();
  threads.run([&] {
    StageTimer timer(answer.times);
    const auto triangulation =
        std::make_shared<const Triangulation>(make_triangulation(*balls, threads.used(), context));
    timer.lap(stage::kTriangulation, true);
    const auto ground = std::make_shared<const CavityGround>(
        make_cavity_ground(balls, triangulation, options.ties, context));
    timer.lap(stage::kFlow, true);
    answer.table = make_cavity_table(
        ground, {request.alpha_angstrom2, request.solvent_radius_angstrom, options.rule}, context);
    timer.lap(stage::kCavities);
    answer.exact = clip_all(answer.table, context);
    timer.lap(stage::kExactVolumes);
    timer.finish();
  });
  return answer;
}

const ClippedMeasures& exact_of(const Answer& answer, std::size_t row) {
  return answer.exact[answer.table.order[row]];
}

bool doubtful(const Answer& answer, std::size_t row) {
  return is_doubtful(answer.table.measure(row).volume_sa_angstrom3,
                     exact_of(answer, row).volume_sa_angstrom3);
}

const char* kind_text(const CavityTable& table, std::size_t row) {
  return table.cavity(row).is_void() ? "void" : "pocket";
}

std::string comparable_text(const Answer& answer) {
  if (answer.differences.empty()) return "comparable with CASTp";
  std::string text = "not comparable with CASTp: ";
  for (std::size_t k = 0; k < answer.differences.size(); ++k) {
    text += (k ? "; " : "") + answer.differences[k];
  }
  return text;
}

std::string addresses(const std::vector<LiningResidue>& residues) {
  std::string text;
  for (const LiningResidue& residue : residues)
    text += (text.empty() ? "" : "; ") + residue.address;
  return text;
}

// --- as text

std::string totals_text(const CavityTable& table) {
  const auto kind = [&](bool voids, std::size_t number) {
    return grouped(number) + ", SA volume " +
           format_text("%.3f", table.volume_sa_angstrom3(voids)) + " Å³, SA area " +
           format_text("%.3f", table.area_sa_angstrom2(voids)) + " Å²\n";
  };
  return "voids       " + kind(true, table.voids) + "pockets     " + kind(false, table.pockets) +
         "mouths      " + grouped(table.mouths) + "\n";
}

// What a reader must know of the numbers.
std::vector<std::string> notes_of(const CavitiesOptions& options, const Answer& answer) {
  std::vector<std::string> notes;
  const CavityTable& table = answer.table;
  const std::string rounding = rounding_note(options.request, table.ground->balls->lattice);
  if (!rounding.empty()) notes.push_back(rounding);
  if (table.ground->triangulation->dimension < 3) {
    notes.push_back("the centres lie in one plane, so there are no cavities");
  }
  if (table.found.components > 1) {
    notes.push_back("the body has " + grouped(static_cast<std::uint64_t>(table.found.components)) +
                    " separate parts: spaces between them count as pockets");
  }
  return notes;
}

Table cavity_columns() {
  return Table({{"#", 4},
                {"kind", 6, true},
                {"SA vol Å³", 11},
                {"SA area Å²", 11},
                {"exact Å³", 11},
                {"", 1, true},
                {"MS vol Å³", 11},
                {"MS area Å²", 11},
                {"mouths", 6},
                {"mouth Å²", 9},
                {"residues", 8},
                {"name (atoms of the deepest sink)", 0, true}});
}

void print_rows(const Answer& answer, const BallReferences& atoms, std::size_t shown) {
  const CavityTable& table = answer.table;
  const Table columns = cavity_columns();
  if (table.size() == 0 || shown == 0) return;
  std::cout << columns.heading();
  const auto number = [](double value) { return format_text("%.3f", value); };
  for (std::size_t row = 0; row < std::min(shown, table.size()); ++row) {
    const CavityMeasures& m = table.measure(row);
    std::cout << columns.line({std::to_string(row + 1), kind_text(table, row),
                               number(m.volume_sa_angstrom3), number(m.area_sa_angstrom2),
                               number(exact_of(answer, row).volume_sa_angstrom3),
                               doubtful(answer, row) ? "*" : "", number(m.volume_ms_angstrom3),
                               number(m.area_ms_angstrom2), std::to_string(m.mouths.size()),
                               number(m.all_mouths().area_angstrom2),
                               std::to_string(lining_residues(atoms, table, row).size()),
                               cavity_name(atoms, table, row)});
  }
  if (table.size() > shown) {
    std::cout << "… and " << grouped(table.size() - shown)
              << " smaller ones; --show sets how many are printed\n";
  }
  if (verbosity() != Verbosity::quiet && shown > 0) {
    std::cout << "SA, MS: CASTp's sums. exact: of the tetrahedra outside all balls. * below 1 Å³, "
                 "or the two differ by more than a tenth\n";
  }
}

void print(const Input& input, const CavitiesOptions& options, const Answer& answer,
           const BallReferences& atoms) {
  const Request& request = options.request;
  const bool quiet = verbosity() == Verbosity::quiet;
  std::cout << input_text(input) << "sha256      " << input.molecule().sha256 << "\n"
            << "alpha       " << number_text(request.alpha_angstrom2) << " Å², solvent radius "
            << number_text(request.solvent_radius_angstrom) << " Å\n"
            << "choices     " << comparable_text(answer) << "\n"
            << totals_text(answer.table);
  if (!quiet) {
    for (const std::string& note : notes_of(options, answer))
      std::cout << "note        " << note << "\n";
    std::cout << "time        " << milliseconds_text(answer.times.wall_milliseconds) << " ("
              << answer.device << ")\n";
    for (const StageTime& s : answer.times.stages) {
      std::cout << "            " << s.label << " " << milliseconds_text(s.milliseconds) << "\n";
    }
  }
  print_rows(answer, atoms, static_cast<std::size_t>(options.shown));
  std::cout << std::flush;
}

// --- as CSV and JSON

CsvRow csv_row(const Input& input, const CavitiesOptions& options, const Answer& answer,
               const BallReferences& atoms, std::size_t row) {
  const CavityTable& table = answer.table;
  const Cavity& cavity = table.cavity(row);
  const CavityMeasures& m = table.measure(row);
  const MouthMeasures mouths = m.all_mouths();
  CsvRow cells{{"model", model_text(input.balls.model)},
               {"rank", std::to_string(row + 1)},
               {"kind", kind_text(table, row)},
               {"name", cavity_name(atoms, table, row)},
               {"volume_sa_angstrom3", all_digits(m.volume_sa_angstrom3)},
               {"area_sa_angstrom2", all_digits(m.area_sa_angstrom2)},
               {"volume_exact_angstrom3", all_digits(exact_of(answer, row).volume_sa_angstrom3)},
               {"area_exact_angstrom2", all_digits(exact_of(answer, row).area_sa_angstrom2)},
               {"doubtful", doubtful(answer, row) ? "1" : "0"},
               {"volume_ms_angstrom3", all_digits(m.volume_ms_angstrom3)},
               {"area_ms_angstrom2", all_digits(m.area_ms_angstrom2)},
               {"area_ms_steiner_angstrom2", all_digits(m.area_ms_steiner_angstrom2)},
               {"volume_of_tetrahedra_angstrom3", all_digits(m.volume_of_tetrahedra_angstrom3)},
               {"mouths", std::to_string(m.mouths.size())},
               {"mouth_triangles", std::to_string(cavity.mouth_triangles())},
               {"mouth_area_angstrom2", all_digits(mouths.area_angstrom2)},
               {"mouth_length_angstrom", all_digits(mouths.length_angstrom)},
               {"arc_length_angstrom", all_digits(m.arc_length_angstrom)},
               {"corners", std::to_string(m.corners)},
               {"tetrahedra", std::to_string(cavity.tetrahedra.size())},
               {"sinks", std::to_string(cavity.sinks)},
               {"atoms", std::to_string(cavity.atoms.size())},
               {"lining_atoms", std::to_string(m.lining.size())},
               {"lining_residues", addresses(lining_residues(atoms, table, row))},
               {"alpha_angstrom2", number_text(options.request.alpha_angstrom2)},
               {"solvent_radius_angstrom", number_text(options.request.solvent_radius_angstrom)},
               {"choices", comparable_text(answer)}};
  for (auto& [key, value] : input.provenance()) {
    if (key != "model") cells.emplace_back(key, std::move(value));
  }
  cells.emplace_back("program", program_text());
  return cells;
}

Json mouths_json(const Cavity& cavity, const CavityMeasures& m) {
  Json mouths = Json::array();
  for (std::size_t k = 0; k < m.mouths.size(); ++k) {
    mouths.push_back({{"triangles", cavity.mouths[k].triangles.size()},
                      {"area_angstrom2", m.mouths[k].area_angstrom2},
                      {"length_angstrom", m.mouths[k].length_angstrom}});
  }
  return mouths;
}

Json cavity_json(const Answer& answer, const BallReferences& atoms, std::size_t row) {
  const CavityTable& table = answer.table;
  const Cavity& cavity = table.cavity(row);
  const CavityMeasures& m = table.measure(row);
  Json residues = Json::array();
  for (const LiningResidue& residue : lining_residues(atoms, table, row)) {
    residues.push_back({{"residue", residue.address}, {"atoms", residue.balls}});
  }
  return {{"rank", row + 1},
          {"kind", kind_text(table, row)},
          {"name", cavity_name(atoms, table, row)},
          {"sink_atoms", table.sink(row)},
          {"volume_sa_angstrom3", m.volume_sa_angstrom3},
          {"area_sa_angstrom2", m.area_sa_angstrom2},
          {"volume_exact_angstrom3", exact_of(answer, row).volume_sa_angstrom3},
          {"area_exact_angstrom2", exact_of(answer, row).area_sa_angstrom2},
          {"doubtful", doubtful(answer, row)},
          {"volume_ms_angstrom3", m.volume_ms_angstrom3},
          {"area_ms_angstrom2", m.area_ms_angstrom2},
          {"area_ms_steiner_angstrom2", m.area_ms_steiner_angstrom2},
          {"volume_of_tetrahedra_angstrom3", m.volume_of_tetrahedra_angstrom3},
          {"mouths", mouths_json(cavity, m)},
          {"arc_length_angstrom", m.arc_length_angstrom},
          {"corners", m.corners},
          {"tetrahedra", cavity.tetrahedra.size()},
          {"sinks", cavity.sinks},
          {"atoms", cavity.atoms},
          {"lining_residues", residues}};
}

Json result_json(const Input& input, const CavitiesOptions& options, const Answer& answer,
                 const BallReferences& atoms) {
  const CavityTable& table = answer.table;
  Json cavities = Json::array(), stages = Json::array();
  for (std::size_t row = 0; row < table.size(); ++row) {
    cavities.push_back(cavity_json(answer, atoms, row));
  }
  for (const StageTime& s : answer.times.stages) {
    stages.push_back({{"stage", s.label}, {"ms", s.milliseconds}, {"setup", s.setup}});
  }
  Json request = request_json(options.request, table.ground->balls->lattice);
  for (const char* unused : {"tetrahedra_only", "engine"}) request.erase(unused);
  return {
      {"comparable_with_castp", answer.differences.empty()},
      {"differences_from_castp", answer.differences},
      {"counts",
       {{"voids", table.voids},
        {"pockets", table.pockets},
        {"mouths", table.mouths},
        {"components", table.found.components},
        {"tunnels", table.found.tunnels}}},
      {"cavities", cavities},
      {"notes", notes_of(options, answer)},
      {"timings_ms",
       {{"wall", answer.times.wall_milliseconds}, {"device", answer.device}, {"stages", stages}}},
      {"request", request},
      {"input", input_json(input)}};
}

}  // namespace

ExitCode run_cavities(const CavitiesOptions& options) {
  const RunContext& context = run_context();
  FilesCommand command(options.files, options.input,
                       body_options(options.input, options.body, context),
                       {options.json, options.csv});
  return command.run([&](const std::string&, const Input& as_opened) {
    const Input input = with_body_radii(as_opened, options.input);
    const Answer answer = find(input, options, context);
    const BallReferences atoms(input.opened.molecule, input.opened.prepared);
    clear_progress();
    if (command.shown()) print(input, options, answer, atoms);
    if (command.json.wanted()) command.json.add(result_json(input, options, answer, atoms));
    for (std::size_t row = 0; command.csv.wanted() && row < answer.table.size(); ++row) {
      command.csv.add(csv_row(input, options, answer, atoms, row));
    }
  });
}

}  // namespace alphascope::cli
