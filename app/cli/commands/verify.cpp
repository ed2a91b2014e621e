// SPDX-License-Identifier: GPL-3.0-or-later
// Runs alphascope-cli verify, which compares our complex with CGAL's, simplex by simplex. If our
// complex comes from CGAL's triangulation as well, it is also checked against the definition of the
// complex.
#include "core/verify/verify.hpp"

#include <algorithm>
#include <iostream>

#include "app/cli/command.hpp"
#include "app/cli/commands/verify.hpp"
#include "app/cli/failure.hpp"
#include "app/cli/option_groups.hpp"
#include "app/cli/outputs.hpp"
#include "app/cli/report_json.hpp"
#include "app/cli/text/terminal.hpp"
#include "app/cli/text/text.hpp"
#include "app/options/option_values.hpp"
#include "app/session/rounding_note.hpp"
#include "core/molecule/molecule.hpp"

namespace alphascope::cli {
namespace {

template <int N>
std::string simplex_text(const std::array<BallIndex, N>& simplex, const Input& input) {
  std::string text;
  for (const BallIndex vertex : simplex) {
    text += (text.empty() ? "" : ", ") + std::to_string(vertex) + " (" +
            atom_label(input.molecule(), input.prepared().atom_of_ball[vertex]) + ")";
  }
  return text;
}

template <int N>
void print_set(std::ostream& out, const char* name, const SetDifference<N>& set, const Input& input,
               std::size_t shown) {
  const std::size_t reference = set.common + set.missing.size();
  out << "  " << name << ": " << grouped(set.common) << " of " << grouped(reference);
  if (!set.extra.empty())
    out << ", and " << grouped(set.extra.size()) << " that CGAL's complex lacks";
  out << "\n";
  const auto print = [&](const char* kind, const auto& list) {
    for (std::size_t i = 0; i < std::min(shown, list.size()); ++i) {
      out << "    " << kind << " " << simplex_text<N>(list[i], input) << "\n";
    }
    if (list.size() > shown) {
      out << "    … and " << grouped(list.size() - shown) << " more\n";
    }
  };
  print("missing", set.missing);
  print("extra  ", set.extra);
}

void print_comparison(std::ostream& out, const Comparison& comparison, const Input& input,
                      std::size_t shown) {
  if (!comparison.tetrahedra_only) {
    print_set(out, "vertices", comparison.vertices, input, shown);
    print_set(out, "edges", comparison.edges, input, shown);
    print_set(out, "triangles", comparison.triangles, input, shown);
  }
  print_set(out, "tetrahedra", comparison.tetrahedra, input, shown);
  if (!comparison.tetrahedra_only) {
    out << "  alpha values that differ: " << grouped(comparison.alpha_values_differing)
        << "; classes that differ: " << grouped(comparison.classes_differing) << "\n";
  }
}

// Checks the complex against its definition, and prints all faults. Returns true if there are none.
bool check_definition(std::ostream& out, const BallSet& balls, const AlphaComplex& complex,
                      Json& json) {
  const Verification found = verify(balls, complex, run_context());
  clear_progress();
  out << "  definition: " << grouped(found.checks) << " facts checked, " << grouped(found.failures)
      << " false\n";
  for (const std::string& message : found.messages) out << "    " << message << "\n";
  json["definition"] = {{"checks", found.checks}, {"failures", found.failures}};
  return found.ok();
}

const char* verdict(const Comparison& comparison) {
  if (!comparison.identical()) return "DIFFERS FROM CGAL";
  return comparison.both_rest_on_cgal
             ? "both rest on CGAL's triangulation; checked against the definition instead"
             : "identical to CGAL";
}

struct BothEngines {
  explicit BothEngines(const EngineFactory& factory) : ours(factory), cgal(factory) {}
  EngineCache ours, cgal;
};

// Computes and compares both complexes at one alpha, prints, and fills `json`. True if nothing
// differs.
bool verify_one(const Input& input, const Request& request, const VerifyOptions& options,
                BothEngines& engines, Json& json) {
  std::ostream& out = std::cout;
  const RunContext& context = run_context();
  const auto answer = engines.ours.compute_shared(input.prepared().balls, request, context);
  const EngineAnswer& mine = *answer;
  Request cgal = request;
  cgal.engine = EngineChoice::cgal;
  cgal.threads = options.cgal_threads;
  const EngineAnswer theirs = engines.cgal.compute(input.prepared().balls, cgal, context);
  const Comparison comparison = compare(mine.complex, theirs.complex);
  clear_progress();
  out << "alpha " << shortest_number(request.alpha_angstrom2) << " Å², solvent radius "
      << shortest_number(request.solvent_radius_angstrom) << " Å: " << verdict(comparison) << " ("
      << mine.complex.engine.name
      << (times_wanted() ? ", " + mine.complex.engine.route : std::string()) << "; hash "
      << hash_text(mine.complex.hash) << ")\n";
  const std::string rounding = rounding_note(request, mine.balls->lattice);
  if (!rounding.empty()) out << "  note: " << rounding << "\n";
  print_comparison(out, comparison, input, options.shown);
  json = {{"input", input_json(input, mine.balls->lattice)},
          {"request", request_json(request, mine.balls->lattice)},
          {"comparison", comparison_json(comparison)},
          {"ours", complex_json(mine.complex, mine.note)},
          {"cgal", complex_json(theirs.complex, theirs.note)}};
  const bool define = options.definition || comparison.both_rest_on_cgal;
  const bool defined = !define || check_definition(out, *mine.balls, mine.complex, json);
  return comparison.identical() && defined;
}

}  // namespace

ExitCode run_verify(const VerifyOptions& options, const EngineFactory& factory) {
  if (options.request.engine == EngineChoice::cgal) {
    throw UsageError("verify compares with CGAL, so --engine cgal would compare CGAL with itself.");
  }
  const RunContext& context = run_context();
  require_readable({options.input.file});
  Outputs outputs(files_read(options.input));
  AtomicFile* const file = outputs.add("--json", options.json, Outputs::kJson);
  std::ostream& out = std::cout;
  Json results = Json::array(), first_input;
  bool all_good = true;
  for_each_model(options.input, context, [&](const Input& input) {
    clear_progress();
    out << input_text(input);
    BothEngines engines(factory);
    for (const Alpha& alpha : options.alphas) {
      Request request = options.request;
      request.alpha_angstrom2 = alpha;
      Json json;
      all_good &= verify_one(input, request, options, engines, json);
      if (first_input.is_null()) first_input = json["input"];
      if (!each_model(options.input)) json.erase("input");
      results.push_back(std::move(json));
      out << std::flush;
    }
  });
  if (file) {
    file->write(json_text(json_to_write({{"identical", all_good},
                                         {"results", results},
                                         {"input", first_input},
                                         {"program", program_json()}})));
    outputs.commit();
  }
  return all_good ? ExitCode::ok : ExitCode::differs;
}

namespace {

OptionCommand table_of_verify(VerifyOptions& options) {
  OptionCommand command{
      "verify", "Compare with CGAL as sets of simplices; exit code 0 only if identical", {}};
  command.options = {one_file(options.input),
                     required(alphas(options.alphas, "Alphas in Å², such as -1,0,1.4"))};
  append(command.options, engine(options.request, true));
  append(command.options,
         {with_default(whole_number_option({"--cgal-threads", "N", "Threads for CGAL, 0 for all"},
                                           options.cgal_threads, kThreadRange),
                       "1"),
          flag_option("--definition",
                      "Also check the complex against its definition, without CGAL: every simplex "
                      "is right, and none is missing",
                      options.definition),
          whole_number_option({"--show", "N", "Differences printed for each kind of simplex"},
                              options.shown, {0, 1'000'000'000}),
          output("--json", "The comparison as JSON; - for standard output", options.json)});
  append(command.options, input(options.input));
  command.check = [&options] { require_tuple_engine(options.request); };
  return command;
}

ExitCode run(const VerifyOptions& options) {
  return run_verify(options);
}

}  // namespace

Command verify_command() {
  return make_command<VerifyOptions>(table_of_verify, run,
                                     {"alphascope-cli verify 1crn.pdb --alpha -1,0,1.4,10"});
}

}  // namespace alphascope::cli
