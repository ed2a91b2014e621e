// The options of alphascope-cli cavities and channel.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/cli/cavities/shape_outputs.hpp"
#include "app/cli/option_groups.hpp"
#include "core/channel/ways_through.hpp"
#include "core/document/settings/cavity_preset.hpp"

namespace alphascope::cli {
namespace {

// The body whose cavities are looked for.
Options body(InputOptions& input, BodyOptions& body) {
  Options options = input_but_ligands(input);
  for (Option& option : options) {
    if (option.names == "--radii") option.fallback = "the file's own, else castp";
  }
  append(options, {flag_option("--ligands", "Ligands are part of the body, too", body.ligands),
                   flag_option("--ions", "Ions are part of the body, too", body.ions)});
  return options;
}

// Throws std::invalid_argument.
void require_three(const char* name, const std::vector<double>& numbers) {
  if (numbers.size() == 3 || numbers.empty()) return;
  throw std::invalid_argument(std::string(name) + " takes three numbers, such as 1.5,-2,30");
}

}  // namespace

OptionCommand cavities_command(CavitiesOptions& options) {
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
  Option rule{.names = "--rule",
              .value = "castp|pocket",
              .text = "What is outside where the flow goes both ways: castp keeps it in a pocket",
              .fallback = "castp"};
  rule.set = [&options, choices = rule.choices()](const std::string& id) {
    require_choice(id, choices);
    options.rule = id == "pocket" ? OutsideRule::pocket : OutsideRule::castp;
  };
  Option ties{.names = "--ties",
              .value = "perturbed|strict",
              .text = "Orthocentres in the plane of a face: perturbed, or do not flow (strict)",
              .fallback = "perturbed"};
  ties.set = [&options, choices = ties.choices()](const std::string& id) {
    require_choice(id, choices);
    options.ties = id == "strict" ? FlowTies::strict : FlowTies::perturbed;
  };
  Option min_volume{.names = "--min-volume",
                    .value = "V",
                    .text = "List only cavities of an SA volume of at least V, in Å³"};
  min_volume.set = [&options](const std::string& text) {
    options.min_volume_angstrom3 = number_in(text, {-1e30, 1e30});
  };
  append(
      command.options,
      {rule, ties, min_volume,
       flag_option(
           "--no-clipped",
           "Leave out the exact clipped volumes, which take longest of many cospherical atoms",
           options.no_clipped),
       flag_option("--split-networks",
                   "List networks (20 mouths or more) as the parts that they fall into at their "
                   "bottlenecks",
                   options.split_networks),
       flag_option("--no-network-radius",
                   "Leave out at which solvent radius networks fall apart, which takes a few "
                   "triangulations",
                   options.no_network_radius),
       with_default(whole_number_option({"--show", "N", "Cavities printed, the largest first"},
                                        options.shown, {0, 1'000'000'000}),
                    "20"),
       output("--json", "All numbers, mouths and residues as JSON; - for standard output",
              options.json),
       output("--csv", "One row for each cavity; - for standard output", options.csv),
       output("--lives",
              "Between which alphas each cavity is there, of every alpha, as CSV; - for standard "
              "output",
              options.lives)});
  append(command.options, shape_options(options.shapes, "Spheres that fill the cavities, as PQR",
                                        "Surfaces of the cavities as a mesh",
                                        "A script that shows the cavities in ChimeraX or PyMOL"));
  Options of_body = body(options.input, options.body);
  for (Option& option : of_body) {
    if (option.names != "--radii") continue;
    option = with_default(texts_option({"--radii", radii_choices(),
                                        "Radii as of other commands; several, such as castp,bondi, "
                                        "are compared side by side"},
                                       options.radii),
                          option.fallback);
  }
  append(command.options, of_body);
  command.check = [&options] { require_files(options.files); };
  return command;
}

OptionCommand channel_command(ChannelOptions& options) {
  OptionCommand command{
      "channel",
      "How large a ball passes through a molecule, or from a point or a cavity, and its profile",
      {}};
  options.solvent_radius_angstrom = kCavitySolventAngstrom;
  const NumberRange kPlaceRange{-1e9, 1e9, "Å"};
  const auto place = [&](const char* name, const char* text, std::vector<double>& target) {
    return numbers_option({name, "X,Y,Z", text}, target, kPlaceRange);
  };
  command.options = {
      one_file(options.input),
      with_default(whole_number_option({"--way", "N",
                                        "Without --point and --cavity: way N through the "
                                        "molecule, of those that are listed"},
                                       options.way, {1, static_cast<int>(kMostWays)}),
                   "1, the best"),
      place("--point", "Begin at this point in the channel, in Å", options.point),
      whole_number_option({"--cavity", "N", "Begin in the widest place of cavity N of 'cavities'"},
                          options.cavity, {1, 1'000'000'000}),
      numbers_option({"--mouth", "M|M,K", "To mouth M of the cavity, or from mouth M to mouth K"},
                     options.mouths, {1, 1e9, ""}),
      with_default(number_option({"--solvent", "S", "Solvent radius of the cavity, in Å"},
                                 options.solvent_radius_angstrom, kSolventRange),
                   "1.4"),
      place("--along", "Through the start both ways along this direction", options.along),
      place("--to", "From the start to this point, in Å", options.to),
      number_option({"--end-radius", "R", "Outwards the line ends where it is so wide, in Å"},
                    options.end_radius_angstrom, {0, 1000, "Å"}),
      with_default(
          whole_number_option({"--threads", "N", "CPU threads"}, options.threads, kThreadRange),
          "0 = all"),
      output("--json", "Bottleneck, touching atoms and line as JSON; - for standard output",
             options.json),
      output("--csv", "The profile, one row for each sample; - for standard output", options.csv)};
  append(command.options, shape_options(options.shapes, "Spheres along the channel, as PQR",
                                        "The surface of the channel as a mesh",
                                        "A script that shows the channel in ChimeraX or PyMOL"));
  append(command.options, body(options.input, options.body));
  command.check = [&options] {
    require_three("--point", options.point);
    require_three("--along", options.along);
    require_three("--to", options.to);
    if (!options.point.empty() && options.cavity != 0) {
      throw std::invalid_argument("--point and --cavity exclude each other");
    }
    if (!options.is_way() && options.way != 0) {
      throw std::invalid_argument("--way needs no --point and no --cavity: it has no given ends");
    }
    if (options.is_way() && (!options.along.empty() || !options.to.empty() ||
                             options.end_radius_angstrom != ChannelEnds{}.end_radius_angstrom)) {
      throw std::invalid_argument(
          "--along, --to and --end-radius need --point X,Y,Z or --cavity N");
    }
    if (!options.mouths.empty() && options.cavity == 0) {
      throw std::invalid_argument("--mouth needs --cavity: mouths are those of a cavity");
    }
    if (options.mouths.size() > 2 ||
        std::any_of(options.mouths.begin(), options.mouths.end(),
                    [](double mouth) { return mouth != std::floor(mouth); })) {
      throw std::invalid_argument("--mouth takes one whole number or two, such as 1 or 1,2");
    }
    if (!options.along.empty() + !options.to.empty() + !options.mouths.empty() > 1) {
      throw std::invalid_argument("--along, --to and --mouth exclude each other");
    }
  };
  return command;
}

}  // namespace alphascope::cli
