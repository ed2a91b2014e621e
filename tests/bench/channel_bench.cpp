// SPDX-License-Identifier: GPL-3.0-or-later
// Prints one channel: its bottleneck, its profile, and the time to find it.
//
//   alphascope_channel_bench FILE.balls|FILE.xyzr between X Y Z X Y Z
//   alphascope_channel_bench FILE.balls|FILE.xyzr out X Y Z
//   alphascope_channel_bench FILE.balls|FILE.xyzr out_along|through X Y Z  DX DY DZ
//   alphascope_channel_bench FILE.balls|FILE.xyzr bottlenecks SOLVENT (Å; of all cavities)
// Environment: THREADS, END_RADIUS (Å), PROFILE=1 (all samples: x y z radius along).
#include <tbb/global_control.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/cavity_shape/cavity_places.hpp"
#include "core/channel/bottlenecks.hpp"
#include "core/channel/channel.hpp"
#include "core/clearance/clearance.hpp"
#include "core/triangulation/flow.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "tests/bench/read_balls.hpp"

namespace {

using namespace alphascope;

ChannelEnds read_ends(int count, char** words) {
  const std::string kind = words[0];
  const auto point = [&](int at) {
    if (at + 3 > count) throw std::runtime_error("too few numbers");
    return RealPoint{std::atof(words[at]), std::atof(words[at + 1]), std::atof(words[at + 2])};
  };
  if (kind == "between") return ChannelEnds::between(point(1), point(4));
  if (kind == "out") return ChannelEnds::out(point(1));
  if (kind == "out_along") return ChannelEnds::out_along(point(1), point(4));
  if (kind == "through") return ChannelEnds::through(point(1), point(4));
  throw std::runtime_error("unknown kind " + kind);
}

const char* limit_name(ChannelLimit limit) {
  return limit == ChannelLimit::end ? "end" : limit == ChannelLimit::plane ? "plane" : "passage";
}

void print(const Channel& channel, double milliseconds) {
  const ChannelSample& least = channel.narrowest();
  std::printf("widest %.4f Å (%s), bottleneck radius %.5f Å at %.3f %.3f %.3f, touching",
              channel.widest_angstrom, limit_name(channel.limit), least.radius_angstrom,
              least.position_angstrom.x, least.position_angstrom.y, least.position_angstrom.z);
  for (const BallIndex ball : channel.touching) std::printf(" %u", ball);
  std::printf("\nlength %.3f Å, %zu samples, end radius %.3f Å\n", channel.length_angstrom,
              channel.samples.size(), channel.end_radius_angstrom);
  std::printf("%d triangulations, %.1f ms\n", channel.triangulations, milliseconds);
  if (std::getenv("PROFILE") == nullptr) return;
  for (const ChannelSample& s : channel.samples) {
    std::printf("%.5f %.5f %.5f %.5f %.5f\n", s.position_angstrom.x, s.position_angstrom.y,
                s.position_angstrom.z, s.radius_angstrom, s.along_angstrom);
  }
}

void print_bottlenecks(const BallSet& balls, double solvent) {
  const auto start = std::chrono::steady_clock::now();
  const auto since = [&] {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
  };
  const auto grown = std::make_shared<const BallSet>(with_solvent(balls, solvent));
  const auto ground = std::make_shared<const CavityGround>(make_cavity_ground(
      grown, std::make_shared<const Triangulation>(make_triangulation(*grown, 1, {}))));
  const CavityTable table = make_cavity_table(ground, {0, solvent});
  const double table_ms = since();
  const Clearance clearance(balls);
  std::vector<RealPoint> places;
  std::vector<double> widest;
  for (std::size_t row = 0; row < table.size(); ++row) {
    const WidestPlace place = widest_place(*ground, table.cavity(row), clearance);
    places.push_back(place.place_angstrom);
    widest.push_back(place.clearance_angstrom);
  }
  const double places_ms = since();
  const Bottlenecks found = find_bottlenecks(balls, places);
  const double end = since();
  for (std::size_t row = 0; row < table.size(); ++row) {
    const Bottleneck& b = found.of[row];
    std::printf("%4zu %-6s %9.2f  widest %.3f  bottleneck %.3f (%.3f to %.3f, kind %d, %zu)\n",
                row + 1, table.cavity(row).is_void() ? "void" : "pocket",
                table.measure(row).volume_sa_angstrom3, widest[row], b.radius_angstrom,
                b.at_least_angstrom, b.below_angstrom, static_cast<int>(b.kind), b.touching.size());
  }
  std::printf("table %.0f ms, places %.0f ms, bottlenecks %.0f ms, %d triangulations\n", table_ms,
              places_ms - table_ms, end - places_ms, found.triangulations);
}

}  // namespace

int main(int count, char** words) {
  try {
    if (count < 3) throw std::runtime_error("which file and which ends?");
    const char* threads = std::getenv("THREADS");
    const tbb::global_control limit(
        tbb::global_control::max_allowed_parallelism,
        threads != nullptr ? static_cast<std::size_t>(std::atoi(threads)) : 2);
    const BallSet balls = bench::read_balls(words[1]);
    if (count == 4 && std::string(words[2]) == "bottlenecks") {
      print_bottlenecks(balls, std::atof(words[3]));
      return 0;
    }
    ChannelEnds ends = read_ends(count - 2, words + 2);
    if (const char* radius = std::getenv("END_RADIUS"))
      ends.end_radius_angstrom = std::atof(radius);
    const auto begin = std::chrono::steady_clock::now();
    const Channel channel = find_channel(balls, ends);
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
    print(channel, time.count());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
