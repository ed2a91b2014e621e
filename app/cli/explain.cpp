// alphascope-cli explain: why a simplex is in the alpha complex, or not.
#include <algorithm>
#include <iostream>
#include <sstream>

#include "app/cli/commands.hpp"
#include "app/cli/outputs.hpp"
#include "app/cli/report_json.hpp"
#include "app/cli/result_files.hpp"
#include "app/cli/terminal.hpp"
#include "app/cli/text.hpp"
#include "app/session/rounding_note.hpp"
#include "core/document/channel_texts.hpp"
#include "core/document/explanation_json.hpp"
#include "core/molecule/atom_address.hpp"
#include "core/molecule/printable.hpp"
#include "core/run/work_threads.hpp"

namespace alphascope::cli {
namespace {

using Balls = std::vector<BallIndex>;

Balls simplex_by_atoms(const BallReferences& atoms, const std::string& text) {
  NamedAtoms named;
  try {
    named = named_atoms(atoms, text);
  } catch (const SelectionError& error) {
    throw UsageError("--atoms \"" + text + "\", " + error.what());
  }
  if (named.balls.empty() || named.balls.size() > 4) {
    throw UsageError(
        "--atoms names " + grouped(named.balls.size()) +
        " atoms that are balls: a simplex has 1 to 4." +
        (named.others > 0 ? " Atoms that are left out of the complex are no balls." : ""));
  }
  Balls simplex;
  for (const Ref& ref : named.balls) {
    const auto balls = atoms.balls(ref);
    simplex.insert(simplex.end(), balls->begin(), balls->end());
  }
  return simplex;
}

Balls simplex_of(const Input& input, const ExplainOptions& options) {
  const BallReferences atoms(input.opened.molecule, input.opened.prepared);
  if (!options.atoms.empty()) return simplex_by_atoms(atoms, options.atoms);
  const std::size_t count = input.prepared().balls->size();
  Balls simplex;
  for (const int index : options.simplex) {
    if (static_cast<std::size_t>(index) >= count) {
      throw UsageError("--simplex: there is no ball " + std::to_string(index) + ": " +
                       printable(input.molecule().source.filename().string()) + " has " +
                       grouped(count) + " balls" +
                       (count > 0 ? ", 0 to " + std::to_string(count - 1) + "." : "."));
    }
    simplex.push_back(static_cast<BallIndex>(index));
  }
  return simplex;
}

// Lines of at most 96 columns; the heading in the first one's margin.
void print_line(std::ostream& out, const ExplanationLine& line) {
  constexpr std::size_t kMargin = 14, kWidth = 82;
  std::string row =
      line.heading + std::string(kMargin - std::min(kMargin, line.heading.size()), ' ');
  std::size_t used = 0;
  const auto columns = [](const std::string& word) {
    return static_cast<std::size_t>(std::count_if(
        word.begin(), word.end(), [](unsigned char c) { return (c & 0xc0) != 0x80; }));
  };
  std::istringstream words(line.text);
  for (std::string word; words >> word;) {
    if (used > 0 && used + 1 + columns(word) > kWidth) {
      out << row << "\n";
      row = std::string(kMargin, ' ');
      used = 0;
    }
    row += (used > 0 ? " " : "") + word;
    used += (used > 0 ? 1 : 0) + columns(word);
  }
  out << row << "\n";
}

Json result_json(const Input& input, const Request& request, const Explanation& e,
                 const BallName& name) {
  Json json = explanation_json(e, name);
  json["request"] = {{"solvent_radius_angstrom", request.solvent_radius_angstrom},
                     {"lattice_unit_angstrom", e.lattice.unit_angstrom()}};
  json["input"] = input_json(input);
  json["program"] = program_json();
  return json;
}

}  // namespace

ExitCode run_explain(const ExplainOptions& options) {
  const RunContext& context = run_context();
  require_readable({options.input.file});
  Outputs outputs(files_read(options.input));
  JsonResults json(outputs.add("--json", options.json), "");
  const bool shown = verbosity() != Verbosity::quiet || !outputs.take_standard_output();
  const Input input = open_one_model(options.input, "A simplex is one model's.", context);
  const Balls simplex = simplex_of(input, options);
  const BallSet balls = with_solvent(*input.prepared().balls, options.solvent_radius_angstrom);
  Request request;
  request.solvent_radius_angstrom = options.solvent_radius_angstrom;
  std::optional<double> alpha;
  if (options.alpha_angstrom2) {
    request.alpha_angstrom2 = *options.alpha_angstrom2;
    alpha = balls.lattice.alpha_on_lattice(*options.alpha_angstrom2);
  }
  Explanation e;
  WorkThreads threads(1);
  const double milliseconds =
      timed([&] { threads.run([&] { e = explain(balls, simplex, alpha, context); }); });
  const BallReferences atoms(input.opened.molecule, input.opened.prepared);
  const BallName name = [&](BallIndex ball) { return atom_text(atoms, ball); };
  clear_progress();
  if (shown) {
    std::cout << input_text(input);
    for (const ExplanationLine& line : explanation_lines(e, name)) print_line(std::cout, line);
    const std::string note = rounding_note(request, balls.lattice);
    if (!note.empty()) print_line(std::cout, {"Note", note});
    if (verbosity() != Verbosity::quiet) {
      print_line(std::cout, {"Time", milliseconds_text(milliseconds)});
    }
    std::cout << std::flush;
  }
  if (json.wanted()) json.add(result_json(input, request, e, name));
  json.finish(Json::object());
  outputs.commit();
  return ExitCode::ok;
}

}  // namespace alphascope::cli
