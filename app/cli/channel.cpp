// alphascope-cli channel: how large a ball can walk from a point of a molecule outwards, or to
// another point, and the profile of its way.
#include <chrono>
#include <iostream>

#include "app/cli/commands.hpp"
#include "app/cli/outputs.hpp"
#include "app/cli/report_json.hpp"
#include "app/cli/result_files.hpp"
#include "app/cli/terminal.hpp"
#include "app/cli/text.hpp"
#include "core/cavity/channel.hpp"
#include "core/molecule/atom_address.hpp"
#include "core/run/work_threads.hpp"

namespace alphascope::cli {
namespace {

struct Answer {
  Channel channel;
  double milliseconds = 0;
  std::string device;
};

RealPoint point_of(const std::vector<double>& numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

ChannelEnds ends_of(const ChannelOptions& options) {
  const RealPoint from = point_of(options.point);
  ChannelEnds ends = !options.to.empty()      ? ChannelEnds::between(from, point_of(options.to))
                     : !options.along.empty() ? ChannelEnds::through(from, point_of(options.along))
                                              : ChannelEnds::out(from);
  ends.end_radius_angstrom = options.end_radius_angstrom;
  return ends;
}

std::string atom_text(const Input& input, BallIndex ball) {
  return atom_address(input.molecule(), input.prepared().atom_of_ball.at(ball));
}

Answer find(const Input& input, const ChannelOptions& options, const RunContext& context) {
  WorkThreads threads(options.threads);
  Answer answer;
  answer.device = threads.text();
  const auto start = std::chrono::steady_clock::now();
  try {
    threads.run(
        [&] { answer.channel = find_channel(*input.prepared().balls, ends_of(options), context); });
  } catch (const ChannelEndCovered& error) {
    throw UsageError(std::string(error.what()) + " That ball is the atom " +
                     atom_text(input, error.ball) + ".");
  } catch (const std::invalid_argument& error) {
    throw UsageError(std::string(error.what()) + ".");
  }
  answer.milliseconds =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return answer;
}

const char* limit_text(ChannelLimit limit) {
  switch (limit) {
    case ChannelLimit::passage:
      return "between the atoms that touch it";
    case ChannelLimit::end:
      return "at a given point: the way is wider everywhere else";
    case ChannelLimit::plane:
      break;
  }
  return "at the plane through the point: another point in the channel, or another direction, may "
         "find a wider way";
}
const char* limit_id(ChannelLimit limit) {
  return limit == ChannelLimit::passage ? "passage" : limit == ChannelLimit::end ? "end" : "plane";
}

std::string place_text(const RealPoint& p) {
  return format_text("%.3f, %.3f, %.3f", p.x, p.y, p.z);
}

void print(const Input& input, const Answer& answer) {
  const Channel& channel = answer.channel;
  std::string touching;
  for (const BallIndex ball : channel.touching) {
    touching += (touching.empty() ? "" : ", ") + atom_text(input, ball);
  }
  std::cout << input_text(input) << "sha256      " << input.molecule().sha256 << "\n"
            << "bottleneck  radius " << format_text("%.3f", channel.widest_angstrom) << " Å"
            << (channel.is_open() ? "" : ": closed, not even a point passes") << "\n"
            << "            at " << place_text(channel.narrowest().position_angstrom) << " Å, "
            << limit_text(channel.limit) << "\n"
            << "touching    " << touching << "\n"
            << "length      " << format_text("%.2f", channel.length_angstrom) << " Å, "
            << grouped(channel.samples.size()) << " samples\n";
  if (verbosity() != Verbosity::quiet) {
    std::cout << "time        " << milliseconds_text(answer.milliseconds) << " (" << answer.device
              << ", " << channel.triangulations << " triangulations)\n";
  }
  std::cout << std::flush;
}

CsvRow csv_row(const Input& input, const ChannelSample& sample) {
  CsvRow row{{"along_angstrom", all_digits(sample.along_angstrom)},
             {"radius_angstrom", all_digits(sample.radius_angstrom)},
             {"x_angstrom", all_digits(sample.position_angstrom.x)},
             {"y_angstrom", all_digits(sample.position_angstrom.y)},
             {"z_angstrom", all_digits(sample.position_angstrom.z)}};
  for (auto& entry : input.provenance()) row.push_back(std::move(entry));
  row.emplace_back("program", program_text());
  return row;
}

Json point_json(const RealPoint& p) {
  return {p.x, p.y, p.z};
}

Json result_json(const Input& input, const ChannelOptions& options, const Answer& answer) {
  const Channel& channel = answer.channel;
  Json touching = Json::array(), samples = Json::array();
  for (const BallIndex ball : channel.touching) {
    touching.push_back({{"ball", ball}, {"atom", atom_text(input, ball)}});
  }
  for (const ChannelSample& sample : channel.samples) {
    samples.push_back({{"along_angstrom", sample.along_angstrom},
                       {"radius_angstrom", sample.radius_angstrom},
                       {"position_angstrom", point_json(sample.position_angstrom)}});
  }
  Json request{{"point_angstrom", options.point}};
  if (!options.to.empty()) request["to_angstrom"] = options.to;
  if (!options.along.empty()) request["along"] = options.along;
  request["end_radius_angstrom"] = options.end_radius_angstrom;
  return {{"widest_angstrom", channel.widest_angstrom},
          {"step_angstrom", channel.step_angstrom},
          {"open", channel.is_open()},
          {"limit", limit_id(channel.limit)},
          {"bottleneck",
           {{"position_angstrom", point_json(channel.narrowest().position_angstrom)},
            {"radius_angstrom", channel.narrowest().radius_angstrom},
            {"along_angstrom", channel.narrowest().along_angstrom},
            {"touching", touching}}},
          {"length_angstrom", channel.length_angstrom},
          {"samples", samples},
          {"timings_ms",
           {{"wall", answer.milliseconds},
            {"device", answer.device},
            {"triangulations", channel.triangulations}}},
          {"request", request},
          {"input", input_json(input)},
          {"program", program_json()}};
}

}  // namespace

ExitCode run_channel(const ChannelOptions& options) {
  const RunContext& context = run_context();
  require_readable({options.input.file});
  Outputs outputs(files_read(options.input));
  CsvResults csv(outputs.add("--csv", options.csv));
  JsonResults json(outputs.add("--json", options.json), "");
  const bool shown = verbosity() != Verbosity::quiet || !outputs.take_standard_output();
  if (each_model(options.input)) {
    throw UsageError("A channel is one model's. Give the number of a model, or joined.");
  }
  const OpenOptions open = body_options(options.input, options.body, context);
  for_each_model(options.input.file, options.input, open, context, [&](const Input& as_opened) {
    const Input input = with_body_radii(as_opened, options.input);
    const Answer answer = find(input, options, context);
    clear_progress();
    if (shown) print(input, answer);
    for (const ChannelSample& sample : answer.channel.samples) {
      if (csv.wanted()) csv.add(csv_row(input, sample));
    }
    if (json.wanted()) json.add(result_json(input, options, answer));
  });
  json.finish(Json::object());
  outputs.commit();
  return ExitCode::ok;
}

}  // namespace alphascope::cli
