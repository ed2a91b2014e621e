// SPDX-License-Identifier: GPL-3.0-or-later
// Runs alphascope-cli channel, which finds the largest ball that can move through a molecule, and
// the radii along its way. The way may also start at a point or cavity, and end at another point or
// a mouth.
#include <algorithm>
#include <chrono>
#include <iostream>
#include <memory>
#include <utility>

#include "app/cli/cavities/shape_outputs.hpp"
#include "app/cli/command.hpp"
#include "app/cli/derived_results.hpp"
#include "app/cli/failure.hpp"
#include "app/cli/option_groups.hpp"
#include "app/cli/outputs.hpp"
#include "app/cli/report_json.hpp"
#include "app/cli/result_files.hpp"
#include "app/cli/text/terminal.hpp"
#include "app/cli/text/text.hpp"
#include "app/options/option_values.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/channel/ways_through.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/document/channels/channel_export.hpp"
#include "core/document/channels/channel_json.hpp"
#include "core/document/channels/channel_records.hpp"
#include "core/document/channels/channel_results.hpp"
#include "core/document/channels/channel_text.hpp"
#include "core/document/settings/cavity_preset.hpp"
#include "core/document/store/inputs.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/point_text.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/radii/radii_set.hpp"
#include "core/run/work_threads.hpp"
#include "core/triangulation/flow.hpp"

namespace alphascope::cli {
namespace {

struct ChannelOptions {
  InputOptions input;
  BodyOptions body;
  // Each has three coordinates (Å) or is empty. A channel without a start point begins in the
  // cavity `cavity`. Without either it leads through the molecule.
  std::vector<double> point, to, along;
  int cavity = 0;              // its number in the table of `cavities`; 0: none
  std::vector<double> mouths;  // numbers of the cavity's mouths, from 1: the end, or both ends
  double solvent_radius_angstrom = 0;  // Å, in the table of `cavities`
  double end_radius_angstrom = 5;
  int way = 0;  // number in the list of ways through; 0: the best
  int threads = 0;
  std::string json, csv;
  ShapeOptions shapes;

  bool is_way() const { return point.empty() && cavity == 0; }
};

struct Answer {
  std::shared_ptr<const FoundChannel> found;  // holds a channel
  FoundWays ways;                             // all ways through, if the channel is one of them
  double milliseconds = 0;
  std::string device;
};

RealPoint point_of(const std::vector<double>& numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

BallReferences atoms_of(const Input& input) {
  return {input.opened.molecule, input.opened.prepared};
}

// The cavity with this number in the table of `alphascope-cli cavities` with the same options.
CavityEnds cavity_ends_of(const Input& input, const ChannelOptions& options, Evaluator& evaluator,
                          const RunContext& context) {
  const double solvent = options.solvent_radius_angstrom;
  const Inputs inputs = derived_inputs(input, solvent, 0);
  const auto table = evaluator.evaluate(cavity_table(), inputs, context);
  const auto rank = static_cast<std::size_t>(options.cavity);
  if (rank > table->size()) {
    throw UsageError("There is no cavity " + grouped(rank) + ": with a solvent radius of " +
                     format_text("%g", solvent) + " Å there are " + grouped(table->size()) +
                     ". List them with 'alphascope-cli cavities'.");
  }
  return *evaluator.evaluate(cavity_ends(table->sink(rank - 1)), inputs, context)->found;
}

RealPoint mouth_of(const CavityEnds& ends, const ChannelOptions& options, double mouth) {
  const auto number = static_cast<std::size_t>(mouth);
  if (number > ends.mouths.size()) {
    throw UsageError("Cavity " + std::to_string(options.cavity) + " has " +
                     (ends.mouths.empty() ? "no mouth: it is a void."
                                          : grouped(ends.mouths.size()) +
                                                (ends.mouths.size() == 1 ? " mouth" : " mouths") +
                                                ", and no mouth " + grouped(number) + "."));
  }
  return ends.mouths[number - 1].place_angstrom;
}

ChannelEnds ends_of(const Input& input, const ChannelOptions& options, Evaluator& evaluator,
                    const RunContext& context) {
  RealPoint from, mouth;
  if (options.cavity > 0) {
    const CavityEnds found = cavity_ends_of(input, options, evaluator, context);
    from = found.widest.place_angstrom;
    if (!options.mouths.empty()) mouth = mouth_of(found, options, options.mouths.back());
    if (options.mouths.size() == 2) from = mouth_of(found, options, options.mouths.front());
  } else {
    from = point_of(options.point);
  }
  ChannelEnds ends = !options.mouths.empty()  ? ChannelEnds::between(from, mouth)
                     : !options.to.empty()    ? ChannelEnds::between(from, point_of(options.to))
                     : !options.along.empty() ? ChannelEnds::through(from, point_of(options.along))
                                              : ChannelEnds::out(from);
  ends.end_radius_angstrom = options.end_radius_angstrom;
  return ends;
}

std::shared_ptr<const FoundChannel> way_of(const FoundWays& ways, const ChannelOptions& options) {
  const auto number = static_cast<std::size_t>(std::max(1, options.way));
  if (number <= ways.ways.size()) return ways.ways[number - 1];
  if (ways.ways.empty()) {
    throw UsageError(
        "No way leads through the molecule from outside to outside. Give --point X,Y,Z or "
        "--cavity N for a channel that ends inside.");
  }
  throw UsageError("There is no way " + grouped(number) + ": " + grouped(ways.ways.size()) +
                   (ways.ways.size() == 1 ? " way leads" : " ways lead") +
                   " through the molecule.");
}

void require_channel(const FoundChannel& found, const BallReferences& atoms) {
  if (found.channel) return;
  if (!found.covering) throw UsageError(found.why + ".");
  throw UsageError(found.why + ". That ball is the atom " + atom_text(atoms, *found.covering) +
                   ".");
}

Answer find(const Input& input, const ChannelOptions& options, const RunContext& context) {
  WorkThreads threads(options.threads);
  Answer answer;
  answer.device = threads.text();
  const auto start = std::chrono::steady_clock::now();
  const Inputs as_they_are = derived_inputs(input, 0);
  Evaluator evaluator = make_evaluator();
  try {
    threads.run([&] {
      if (options.is_way()) {
        answer.ways = *evaluator.evaluate(found_ways(), as_they_are, context);
        answer.found = way_of(answer.ways, options);
      } else {
        const ChannelEnds ends = ends_of(input, options, evaluator, context);
        answer.found = evaluator.evaluate(found_channel(ends), as_they_are, context);
      }
    });
  } catch (const std::invalid_argument& error) {
    throw UsageError(std::string(error.what()) + ".");
  }
  require_channel(*answer.found, *as_they_are.atoms);
  answer.milliseconds =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return answer;
}

// Prints one line for each way, so that the user can choose.
void print_ways(const FoundWays& ways, const FoundChannel& chosen) {
  for (const auto& found : ways.ways) {
    const WayFacts& way = *found->way;
    const Channel& channel = *found->channel;
    std::cout << (found->way->number == 1 ? "ways        " : "            ") << way.number
              << (found.get() == &chosen ? " * " : "   ") << way.through << ": radius "
              << bottleneck_radius_text(channel) << " Å at "
              << point_text(channel.narrowest().position_angstrom) << " Å, length "
              << format_text("%.1f", channel.length_angstrom) << " Å, lined by "
              << chains_text(way.lining_chains) << "\n";
  }
  if (ways.parts_left_out > 0) {
    std::cout << "            too many chains: " << grouped(ways.parts_left_out)
              << " were not searched separately\n";
  }
}

void print_cover(const FoundChannel& found) {
  if (found.way) std::cout << "through     " << found.way->through << "\n";
  std::cout << "covers      " << cover_text(*found.cover) << "\n"
            << "passes      " << passing_waters_text(found) << "\n";
  if (!found.way || pore_contents_text(*found.way).empty()) return;
  std::cout << "not counted " << pore_contents_text(*found.way) << " in it\n";
}

void print(const Input& input, const Answer& answer) {
  const Channel& channel = *answer.found->channel;
  std::cout << input_text(input) << "sha256      " << input.molecule().sha256 << "\n";
  print_ways(answer.ways, *answer.found);
  std::cout << "bottleneck  radius " << bottleneck_radius_text(channel) << " Å"
            << (channel.is_open() ? "" : ": closed; not even a point can pass") << "\n"
            << "            at " << point_text(channel.narrowest().position_angstrom) << " Å, "
            << channel_limit_text(channel.limit) << "\n"
            << "touching    " << touching_text(atoms_of(input), channel) << "\n"
            << "length      " << format_text("%.2f", channel.length_angstrom) << " Å, "
            << grouped(channel.samples.size()) << " samples\n";
  print_cover(*answer.found);
  if (times_shown()) {
    std::cout << "time        " << milliseconds_text(answer.milliseconds) << " (" << answer.device
              << ", " << channel.triangulations
              << (channel.triangulations == 1 ? " triangulation)\n" : " triangulations)\n");
  }
  std::cout << std::flush;
}

Json result_json(const Input& input, const ChannelOptions& options, const Answer& answer) {
  Json json = channel_json(atoms_of(input), *answer.found->channel);
  add_cover_json(*answer.found, json);
  if (options.is_way()) {
    json["ways"] = ways_json(answer.ways);
    json["parts_left_out"] = answer.ways.parts_left_out;
  }
  json["timings_ms"] = {{"wall", answer.milliseconds},
                        {"device", answer.device},
                        {"triangulations", answer.found->channel->triangulations}};
  Json& request = json["request"] = channel_request_json(*answer.found);
  if (options.cavity > 0) {
    request["cavity"] = options.cavity;
    request["mouths"] = options.mouths;
    request["solvent_radius_angstrom"] = options.solvent_radius_angstrom;
  }
  json["input"] = input_json(input, input.prepared().balls->lattice);
  json["program"] = program_json();
  return json;
}

void write_shapes(const ShapeOutputs& shapes, const FoundChannel& found,
                  const RecordSource& source) {
  if (shapes.spheres() != nullptr) write_channel_spheres(found, source, *shapes.spheres());
  if (shapes.surface() != nullptr) {
    write_channel_surface(found, source, shapes.surface_is_glb(), *shapes.surface());
  }
  if (shapes.script() == nullptr) return;
  try {
    shapes.script()->write(
        channel_script(found, source, shapes.script_format(), shapes.script_files()));
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
}

ExitCode run_channel(const ChannelOptions& options) {
  const RunContext& context = run_context();
  require_readable({options.input.file});
  Outputs outputs(files_read(options.input));
  CsvResults csv(outputs.add("--csv", options.csv, Outputs::kCsv));
  JsonResults json(outputs.add("--json", options.json, Outputs::kJson), "");
  ShapeOutputs shapes(options.shapes, options.input.file, outputs);
  const bool shown = verbosity() != Verbosity::quiet || !outputs.take_standard_output();
  if (each_model(options.input)) {
    throw UsageError("channel takes one model. Give its number with --model, or --model joined.");
  }
  const OpenOptions open = body_options(options.input, options.body, context);
  for_each_model(options.input.file, options.input, open, context, [&](const Input& as_opened) {
    const Input input = with_body_radii(as_opened, options.input);
    shapes.require_openable(input.molecule());
    const Answer answer = find(input, options, context);
    clear_progress();
    if (shown) print(input, answer);
    const RecordSource source = source_of(input);
    const Provenance provenance = source.provenance();
    for (const ChannelSample& sample : answer.found->channel->samples) {
      if (csv.wanted()) csv.add(channel_csv_row(sample, source, provenance));
    }
    if (json.wanted()) json.add(result_json(input, options, answer));
    write_shapes(shapes, *answer.found, source);
  });
  csv.flush();
  json.finish(Json::object());
  outputs.commit();
  return ExitCode::ok;
}

// Throws std::invalid_argument unless there are three numbers or none.
void require_three(const char* name, const std::vector<double>& numbers) {
  if (numbers.size() == 3 || numbers.empty()) return;
  throw std::invalid_argument(std::string(name) + " needs three numbers, such as 1.5,-2,30");
}

OptionCommand table_of_channel(ChannelOptions& options) {
  OptionCommand command{
      "channel",
      "Find the widest channel through a molecule, or from a point or a cavity, with its profile",
      {}};
  options.solvent_radius_angstrom = kCavitySolventAngstrom;
  const NumberRange kPlaceRange{-1e9, 1e9, "Å"};
  const auto place = [&](const char* name, const char* text, std::vector<double>& target) {
    return numbers_option({name, "X,Y,Z", text}, target, kPlaceRange);
  };
  command.options = {
      one_file(options.input),
      with_default(whole_number_option({"--way", "N",
                                        "Without --point and --cavity: show way N of the "
                                        "listed ways through the molecule"},
                                       options.way, {1, static_cast<int>(kMostWays)}),
                   "1, the best"),
      place("--point", "Begin at this point in the channel, in Å", options.point),
      whole_number_option({"--cavity", "N", "Begin in the widest place of cavity N of 'cavities'"},
                          options.cavity, {1, 1'000'000'000}),
      numbers_option(
          {"--mouth", "M|M,K", "End at mouth M of the cavity, or lead from mouth M to mouth K"},
          options.mouths, {1, 1e9, ""}),
      with_default(number_option({"--solvent", "S", "Solvent radius of the cavity, in Å"},
                                 options.solvent_radius_angstrom, kSolventRange),
                   "1.4"),
      place("--along", "Lead through the start point, in both directions along this vector",
            options.along),
      place("--to", "Lead from the start to this point, in Å", options.to),
      number_option({"--end-radius", "R", "Radius at which a line to the outside ends, in Å"},
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
      throw std::invalid_argument(
          "--way cannot be used with --point or --cavity, which choose an end");
    }
    if (options.is_way() && (!options.along.empty() || !options.to.empty() ||
                             options.end_radius_angstrom != ChannelEnds{}.end_radius_angstrom)) {
      throw std::invalid_argument(
          "--along, --to and --end-radius need --point X,Y,Z or --cavity N");
    }
    if (!options.mouths.empty() && options.cavity == 0) {
      throw std::invalid_argument("--mouth needs --cavity, since a mouth belongs to a cavity");
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

}  // namespace

Command channel_command() {
  return make_command<ChannelOptions>(
      table_of_channel, run_channel,
      {"alphascope-cli channel 1grm.pdb",
       "alphascope-cli channel 1grm.pdb --point 0,0,4.2 --along 0,1,0 --csv profile.csv"});
}

}  // namespace alphascope::cli
