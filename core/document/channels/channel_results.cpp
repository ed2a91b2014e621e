// SPDX-License-Identifier: GPL-3.0-or-later
// Definitions of channels, bottlenecks and ends, with progress, memory and keys.
#include "core/document/channels/channel_results.hpp"

#include <algorithm>
#include <bit>
#include <stdexcept>
#include <utility>

#include "core/cavity/cavities.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/channel/bottlenecks.hpp"
#include "core/channel/centre_line.hpp"
#include "core/document/cavities/cavity_bottlenecks.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/document/cavities/known_cavities.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/store/definition.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/key.hpp"
#include "core/engine/known_results.hpp"
#include "core/selection/prepare_balls.hpp"
#include "core/triangulation/memory_need.hpp"

namespace alphascope {
namespace {

// A number for everything that a channel depends on, except the balls.
std::uint64_t number_of(const ChannelEnds& ends) {
  std::uint64_t number = static_cast<std::uint64_t>(ends.kind) + 1;
  for (const RealPoint& p : {ends.from, ends.to, ends.along}) {
    for (const double value : {p.x, p.y, p.z}) {
      number = Key{number, std::bit_cast<std::uint64_t>(value + 0.0), 0}.number();
    }
  }
  return Key{number, std::bit_cast<std::uint64_t>(ends.end_radius_angstrom), 0}.number();
}

// Progress of a search with an unknown number of triangulations. Each triangulation takes half of
// the share that remains; the centre line has the last part.
class SearchShare {
 public:
  static constexpr double kSearch = 0.8;
  double at(std::string_view stage, double share) {
    if (stage == kCentreLineStage) return most(kSearch + (1 - kSearch) * share);
    if (share < last_) done_ *= 0.5;
    last_ = share;
    return most(kSearch * (1 - done_ * (1 - share / 2)));
  }

 private:
  double most(double share) { return most_ = std::max(most_, share); }
  double last_ = 0, done_ = 1, most_ = 0;
};

RunContext with_one_share(const RunContext& context, SearchShare& share) {
  RunContext all;
  all.cancel = context.cancel;
  all.progress = [&](std::string_view stage, double part) {
    context.report(stage, share.at(stage, part));
  };
  return all;
}

std::shared_ptr<const FoundChannel> make_channel(const Inputs& in, const ChannelEnds& ends,
                                                 const RunContext& context) {
  auto found = std::make_shared<FoundChannel>();
  found->balls = in.balls;
  found->ends = ends;
  SearchShare share;
  try {
    found->channel = find_channel(*in.balls, ends, with_one_share(context, share));
    found->cover = cover_of(*in.balls, *found->channel);
  } catch (const ChannelEndCovered& covered) {
    found->covering = covered.ball;
    found->depth_angstrom = covered.depth_angstrom;
    found->why = covered.what();
  } catch (const std::invalid_argument& error) {
    found->why = error.what();
  }
  return found;
}

// A search holds the triangulation of the widest growth known to be open, and the next two that it
// tests.
MemoryNeed search_memory(const Inputs& in) {
  constexpr std::uint64_t kScenes = 3, kProfile = 1'000'000;
  return {kProfile, kScenes * triangulation_memory(in.balls->size()).peak + kProfile};
}

CavityEnds make_cavity_ends(const CavityGround& ground, const Cavity& cavity,
                            const BallSet& balls_without_solvent) {
  const Clearance clearance(balls_without_solvent);
  CavityEnds ends;
  ends.widest = widest_place(ground, cavity, clearance);
  for (const Mouth& mouth : cavity.mouths) {
    ends.mouths.push_back(widest_place(ground, mouth, clearance));
  }
  return ends;
}

std::shared_ptr<const FoundCavityEnds> make_found_ends(const Inputs& in,
                                                       const std::array<BallIndex, 4>& sink) {
  const CavityTable& table = in.of(cavity_table());
  auto ends = std::make_shared<FoundCavityEnds>();
  ends->sink = sink;
  for (std::size_t row = 0; row < table.size(); ++row) {
    if (table.sink(row) != sink) continue;
    ends->found = make_cavity_ends(*table.ground, table.cavity(row), balls_without_solvent(in));
    break;
  }
  return ends;
}

std::shared_ptr<const CavityBottlenecks> make_bottlenecks(const Inputs& in,
                                                          const RunContext& context) {
  const CavityTable& table = in.of(cavity_table());
  const BallSet balls = balls_without_solvent(in);
  auto result = std::make_shared<CavityBottlenecks>();
  const std::size_t rows = std::min(table.size(), CavityBottlenecks::kMostRows);
  if (rows == 0) return result;
  const Clearance clearance(balls);
  std::vector<RealPoint> places;
  for (std::size_t row = 0; row < rows; ++row) {
    context.cancel.throw_if_cancelled();
    places.push_back(widest_place(*table.ground, table.cavity(row), clearance).place_angstrom);
  }
  result->rows = find_bottlenecks(balls, places, context).of;
  return result;
}

}  // namespace

BallSet without_solvent(const BallSet& grown, double solvent_radius_angstrom) {
  BallSet balls = grown;
  const auto units =
      static_cast<std::int32_t>(grown.lattice.nearest_units(solvent_radius_angstrom));
  for (std::int32_t& radius : balls.radii) radius -= units;
  return balls;
}

BallSet balls_without_solvent(const Inputs& in) {
  return in.atoms ? *in.atoms->prepared().balls
                  : without_solvent(*in.balls, in.solvent_radius_angstrom);
}

Definition<FoundCavityEnds> cavity_ends(const std::array<BallIndex, 4>& sink) {
  return {{.id = "channel.ends",
           .title = "Widest places of the cavity",
           .made_of = {&cavity_table()},
           .key = [sink](const Inputs& in) { return key_of_cavity(in, sink); },
           .memory =
               [](const Inputs& in) {
                 constexpr std::uint64_t kBytesOfBall = 60;  // for sorting balls into grids
                 return MemoryNeed{1'000'000, 1'000'000 + kBytesOfBall * in.balls->size()};
               }},
          [sink](const Inputs& in, const RunContext&) { return make_found_ends(in, sink); }};
}

Definition<FoundChannel> found_channel(const ChannelEnds& ends) {
  return {{.id = "channel",
           .title = "Channel",
           .key =
               [ends](const Inputs& in) {
                 Key key = key_of_balls(in);
                 key.more = number_of(ends);
                 return key;
               },
           .memory = search_memory},
          [ends](const Inputs& in, const RunContext& context) {
            return make_channel(in, ends, context);
          }};
}

const Definition<CavityBottlenecks>& cavity_bottlenecks() {
  static const Definition<CavityBottlenecks> definition{{.id = "cavities.bottlenecks",
                                                         .title = "Bottlenecks of cavities",
                                                         .made_of = {&cavity_table()},
                                                         .key = key_of_balls_and_alpha,
                                                         .memory = search_memory},
                                                        make_bottlenecks};
  return definition;
}

}  // namespace alphascope
