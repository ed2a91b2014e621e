// SPDX-License-Identifier: GPL-3.0-or-later
// Runs alphascope-cli cavities, which finds voids and pockets of each file or model as CASTp does.
// It measures their areas and volumes, and lists their mouths and lining residues.
#include "app/cli/cavities/cavity_answer.hpp"
#include "app/cli/cavities/cavity_comparison.hpp"
#include "app/cli/cavities/cavity_exports.hpp"
#include "app/cli/cavities/cavity_records.hpp"
#include "app/cli/command.hpp"
#include "app/cli/failure.hpp"
#include "app/cli/files_command.hpp"
#include "app/cli/option_groups.hpp"
#include "app/cli/text/terminal.hpp"
#include "app/options/option_values.hpp"
#include "core/document/settings/cavity_preset.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/predicates/flow_predicate.hpp"

namespace alphascope::cli {
namespace {

InputOptions with_radii(InputOptions options, const std::string& radii) {
  options.radii = radii;
  return options;
}

// Gives the molecule the radii of these options. Compared sets must have the same atoms, and
// united-atom sets have none for hydrogens. So a comparison drops hydrogens unless the user keeps
// them.
Input with_radii(Input input, const InputOptions& of, const CavitiesOptions& options) {
  if (!options.compares()) return with_body_radii(std::move(input), of);
  BallOptions balls = body_options(of, options.body, run_context()).balls;
  balls.model = input.balls.model;
  if (of.radii == "auto") balls.radii = cavity_body({}, input.molecule().has_file_radii).radii;
  if (balls.hydrogens == HydrogenRule::automatic) balls.hydrogens = HydrogenRule::drop;
  input.balls = balls;
  input.opened.prepared = std::make_shared<const PreparedBalls>(
      prepare_balls(input.molecule(), input.balls, run_context()));
  return input;
}

void require_same_atoms(const CavityAnswer& first, const CavityAnswer& other) {
  if (first.input.prepared().atom_of_ball == other.input.prepared().atom_of_ball) return;
  throw UsageError(first.input.molecule().source.string() + ": the radii " + variant_text(first) +
                   " and " + variant_text(other) +
                   " are not of the same atoms, so their cavities cannot be matched. Compare "
                   "sets that have a radius for every atom.");
}

std::vector<CavityAnswer> answers_of(const Input& as_opened, const CavitiesOptions& options) {
  std::vector<CavityAnswer> answers;
  for (const std::string& radii : options.radii) {
    const InputOptions of = with_radii(options.input, radii);
    const Input input = with_radii(as_opened, of, options);
    for (const double solvent : options.solvents) {
      answers.push_back(find_cavities_of(input, options, solvent, run_context()));
      require_same_atoms(answers.front(), answers.back());
    }
  }
  return answers;
}

ExitCode run_cavities(const CavitiesOptions& options) {
  const RunContext& context = run_context();
  const InputOptions first = with_radii(options.input, options.radii.front());
  FilesCommand command(options.files, first, body_options(first, options.body, context),
                       {options.json, options.csv});
  CavityExports exports(options, command.outputs);
  return command.run([&](const std::string&, const Input& as_opened) {
    exports.shapes().require_openable(as_opened.molecule());
    const CavityComparison all(answers_of(as_opened, options), context);
    const CavityAnswer& answer = all.answers().front();
    exports.write(answer, context);
    clear_progress();
    if (command.shown()) {
      options.compares() ? print_comparison(all, options) : print_cavities(answer, options);
    }
    if (command.json.wanted()) {
      command.json.add(options.compares() ? comparison_json(all, options)
                                          : result_json(answer, options));
    }
    if (!command.csv.wanted()) return;
    for (std::size_t n = 0; n < all.answers().size(); ++n) {
      for (const std::size_t row : all.answers()[n].rows) {
        command.csv.add(cavity_csv(all.answers()[n], row, all.first_id(n, row)));
      }
    }
  });
}

OptionCommand table_of_cavities(CavitiesOptions& options) {
  OptionCommand command{
      "cavities", "Find voids and pockets with their volumes, areas, mouths and residues", {}};
  Request& request = options.request;
  options.solvents = {kCavitySolventAngstrom};
  command.options = many_files(options.files);
  append(
      command.options,
      {with_default(
           numbers_option({"--solvent", "S",
                           "Solvent radius in Å, as CASTp's probe; several, such as 1.2,1.4, "
                           "are compared side by side"},
                          options.solvents, kSolventRange),
           "1.4"),
       with_default(alpha_option("Alpha in Å²; it may be negative", request.alpha_angstrom2), "0"),
       with_default(
           whole_number_option({"--threads", "N", "CPU threads"}, request.threads, kThreadRange),
           "0 = all")});
  Option rule{
      .names = "--rule",
      .value = "castp|pocket",
      .text =
          "Rule for tetrahedra that flow both outside and to a sink: castp keeps them in a pocket",
      .fallback = "castp"};
  rule.set = [&options, choices = rule.choices()](const std::string& id) {
    require_choice(id, choices);
    options.rule = id == "pocket" ? OutsideRule::pocket : OutsideRule::castp;
  };
  Option ties{.names = "--ties",
              .value = "perturbed|strict",
              .text =
                  "Rule for an orthocentre in the plane of a face: the perturbation decides "
                  "(perturbed), or the tetrahedron does not flow (strict)",
              .fallback = "perturbed"};
  ties.set = [&options, choices = ties.choices()](const std::string& id) {
    require_choice(id, choices);
    options.ties = id == "strict" ? FlowTies::strict : FlowTies::perturbed;
  };
  Option min_volume{.names = "--min-volume",
                    .value = "V",
                    .text = "List only cavities with an SA volume of at least V, in Å³"};
  min_volume.set = [&options](const std::string& text) {
    options.min_volume_angstrom3 = number_in(text, {-1e30, 1e30});
  };
  append(command.options,
         {rule, ties, min_volume,
          flag_option("--no-clipped",
                      "Leave out the exact (clipped) volumes, which take the most time",
                      options.no_exact_volumes),
          flag_option("--split-networks",
                      "List networks (20 mouths or more) as the parts that they fall into at their "
                      "bottlenecks",
                      options.split_networks),
          flag_option("--no-network-radius",
                      "Do not compute the solvent radius at which networks fall apart (it takes a "
                      "few triangulations)",
                      options.no_network_radius),
          with_default(
              whole_number_option({"--show", "N", "Number of cavities to print, the largest first"},
                                  options.shown, {0, 1'000'000'000}),
              "20"),
          output("--json", "All numbers, mouths and residues as JSON; - for standard output",
                 options.json),
          output("--csv", "One row for each cavity; - for standard output", options.csv),
          output("--lives",
                 "Range of alpha in which each cavity exists, as CSV; - for standard output",
                 options.lives)});
  append(command.options, shape_options(options.shapes, "Spheres that fill the cavities, as PQR",
                                        "Surfaces of the cavities as a mesh",
                                        "A script that shows the cavities in ChimeraX or PyMOL"));
  Options of_body = body(options.input, options.body);
  for (Option& option : of_body) {
    if (option.names != "--radii") continue;
    option = with_default(texts_option({"--radii", radii_choices(),
                                        "Radii set, as for other commands; several, such as "
                                        "castp,bondi, are compared side by side"},
                                       options.radii),
                          option.fallback);
  }
  append(command.options, of_body);
  command.check = [&options] { require_files(options.files); };
  return command;
}

}  // namespace

Command cavities_command() {
  return make_command<CavitiesOptions>(table_of_cavities, run_cavities,
                                       {"alphascope-cli cavities 4hhb.pdb.gz --csv cavities.csv"});
}

}  // namespace alphascope::cli
