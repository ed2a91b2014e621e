// SPDX-License-Identifier: GPL-3.0-or-later
// Finds a channel: exact bottleneck, then a curve through it, then the centre line.
#include "core/channel/channel.hpp"

#include <tbb/task_group.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>

#include "core/channel/by_place.hpp"
#include "core/channel/centre_line.hpp"
#include "core/channel/envelope.hpp"
#include "core/channel/passage.hpp"
#include "core/clearance/clearance.hpp"
#include "core/clearance/plane_ascent.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/point_text.hpp"

namespace alphascope {
namespace {

std::string text_of(const RealPoint& p) {
  return "(" + point_text(p) + ") Å";
}

std::string covered_text(const RealPoint& place, BallIndex ball, double depth) {
  char text[96];
  std::snprintf(text, sizeof text, " lies in ball %u, %.3f Å below its surface",
                static_cast<unsigned>(ball), depth);
  return "the channel's end " + text_of(place) + text + "; choose a point outside all balls";
}

std::vector<RealPoint> places_of(const ChannelEnds& ends) {
  if (ends.kind == ChannelEnds::Kind::between) return {ends.from, ends.to};
  return {ends.from};
}

class Finder {
 public:
  Finder(const BallSet& balls, const ChannelEnds& ends, const RunContext& context)
      : balls_(on_passage_lattice(balls, places_of(ends))),
        clearance_(balls_),
        envelope_(balls_),
        ends_(ends),
        context_(context) {}

  Channel find();

 private:
  using Kind = ChannelEnds::Kind;
  bool has_direction() const {
    return ends_.kind == Kind::out_along || ends_.kind == Kind::through;
  }

  LatticePoint end_at(const RealPoint& place) const;
  RealPoint settled_in_plane(const RealPoint& place, const RealPoint& along) const;
  std::vector<Passage> passages();
  std::vector<RealPoint> whole_curve(const std::vector<Passage>& passages) const;
  RealPoint bottleneck_place(const Passage& passage, const RealPoint& on_curve,
                             Channel& channel) const;
  void set_line(const std::vector<Passage>& passages, const Passage& narrowest,
                Channel& channel) const;

  BallSet balls_;
  Clearance clearance_;
  Envelope envelope_;
  const ChannelEnds& ends_;
  const RunContext& context_;
  LatticePoint from_, to_;
};

LatticePoint Finder::end_at(const RealPoint& place) const {
  const LatticePoint point = nearest_lattice_point(balls_.lattice.units_per_angstrom() * place);
  if (growth_room(balls_, point) < 0) {
    const RealPoint rounded = balls_.lattice.unit_angstrom() * real_point(point);
    const Surface surface = clearance_.nearest(rounded);
    throw ChannelEndCovered(rounded, surface.ball, -surface.distance_angstrom);
  }
  return point;
}

RealPoint Finder::settled_in_plane(const RealPoint& place, const RealPoint& along) const {
  // The largest distance from the place to a centre (Å). Clearance above it is possible only
  // outside the molecule.
  double widest = 0;
  for (const LatticePoint& p : balls_.centres) {
    widest = std::max(widest, length(balls_.lattice.unit_angstrom() * real_point(p) - place));
  }
  const Ascent ascent = ascend_in_plane(
      clearance_, place, along, {0.2, 1e-7, widest + 1, std::numeric_limits<double>::infinity()});
  if (!ascent.settled) {
    throw std::invalid_argument("no balls enclose the point " + text_of(place) +
                                " in the plane normal to the direction; choose a point in the "
                                "channel, and a direction along it");
  }
  return ascent.place;
}

// One passage; for Kind::through two, from the point against and along the direction.
std::vector<Passage> Finder::passages() {
  const RealPoint along = unit_vector(ends_.along);
  if (has_direction() && !(std::fabs(length(along) - 1) < 1e-9)) {
    throw std::invalid_argument("the direction of the channel must have a finite length above 0");
  }
  if (!(ends_.end_radius_angstrom > 0)) {
    throw std::invalid_argument("the end radius of a channel must be above 0 Å");
  }
  from_ = end_at(ends_.kind == Kind::through ? settled_in_plane(ends_.from, along) : ends_.from);
  PassageEnds first{from_, {}, {}};
  if (has_direction()) first.direction = along;
  if (ends_.kind == Kind::between) {
    to_ = end_at(ends_.to);
    if (to_ == from_)
      throw std::invalid_argument(
          "both ends of the channel are the same point; choose two different points");
    first.to = to_;
  }
  std::vector<Passage> result(ends_.kind == Kind::through ? 2 : 1);
  if (result.size() == 1) {
    result[0] = widest_passage(balls_, clearance_, first, context_);
    return result;
  }
  PassageEnds second = first;
  second.direction = -1.0 * along;
  RunContext quiet;  // only the caller's thread reports
  quiet.cancel = context_.cancel;
  tbb::task_group other;
  other.run([&] { result[1] = widest_passage(balls_, clearance_, second, quiet); });
  try {
    result[0] = widest_passage(balls_, clearance_, first, context_);
  } catch (...) {
    other.cancel();
    other.wait();
    throw;
  }
  other.wait();
  return result;
}

// The curve of all passages (Å). For Kind::through it comes in along the second passage, reversed,
// and leaves along the first.
std::vector<RealPoint> Finder::whole_curve(const std::vector<Passage>& passages) const {
  std::vector<RealPoint> curve;
  if (passages.size() == 2) {
    curve.assign(passages[1].curve.rbegin(), passages[1].curve.rend() - 1);
  }
  curve.insert(curve.end(), passages[0].curve.begin(), passages[0].curve.end());
  return curve;
}

// The curve lies outside the balls grown by `widest_angstrom`. So its least clearance is within one
// step of the bottleneck's. If that place is in a known gap, the gap gives all its digits.
RealPoint Finder::bottleneck_place(const Passage& passage, const RealPoint& on_curve,
                                   Channel& channel) const {
  constexpr double kRounding = 1e-6, kNear = 0.5;  // Å
  const PassageGap* nearest = nullptr;
  for (const PassageGap& gap : passage.gaps) {
    const double above = gap.clearance_angstrom - channel.widest_angstrom;
    const double away = length(gap.place_angstrom - on_curve);
    if (above < -kRounding || above > channel.step_angstrom + kRounding || away > kNear) continue;
    if (nearest && away >= length(nearest->place_angstrom - on_curve)) continue;
    if (clearance_.at(gap.place_angstrom) > gap.clearance_angstrom - kRounding) nearest = &gap;
  }
  if (nearest != nullptr) {
    if (nearest->at_wall) channel.limit = ChannelLimit::plane;
    return nearest->place_angstrom;
  }
  if (passage.ends_decide && ends_.kind != Kind::through) channel.limit = ChannelLimit::end;
  return on_curve;
}

// Makes the line on both sides of the bottleneck, whose place stays.
void Finder::set_line(const std::vector<Passage>& passages, const Passage& narrowest,
                      Channel& channel) const {
  CutCurve cut = cut_at_least_clearance(clearance_, whole_curve(passages), context_.cancel);
  const RealPoint place = bottleneck_place(narrowest, cut.after.front(), channel);
  if (cut.before.size() > 1) cut.before.back() = place;
  cut.after.front() = place;
  set_channel_line(clearance_, envelope_, cut, passages.size() == 1, ends_.kind == Kind::between,
                   channel, context_);
}

Channel Finder::find() {
  const std::vector<Passage> parts = passages();
  Channel channel;
  const Passage* narrowest = &parts[0];
  for (const Passage& part : parts) {
    channel.triangulations += part.triangulations;
    if (part.widest < narrowest->widest) narrowest = &part;
  }
  const Lattice& lattice = balls_.lattice;
  channel.step_angstrom = lattice.angstrom(static_cast<double>(passage_step(lattice)));
  channel.widest_angstrom = lattice.angstrom(static_cast<double>(narrowest->widest));
  channel.end_radius_angstrom =
      std::max(ends_.end_radius_angstrom, kEndOverBottleneck * channel.widest_angstrom);
  set_line(parts, *narrowest, channel);
  set_touching(clearance_, channel);
  return channel;
}

}  // namespace

ChannelEndCovered::ChannelEndCovered(const RealPoint& place, BallIndex covering, double depth)
    : std::invalid_argument(covered_text(place, covering, depth)),
      place_angstrom(place),
      ball(covering),
      depth_angstrom(depth) {}

Channel find_channel(const BallSet& balls, const ChannelEnds& ends, const RunContext& context) {
  if (balls.size() == 0)
    throw std::invalid_argument("there are no balls, so there is no channel; select atoms");
  const std::vector<BallIndex> order = sorted_by_place(balls);
  try {
    Channel channel = Finder(in_order(balls, order), ends, context).find();
    for (BallIndex& ball : channel.touching) ball = order[ball];
    std::sort(channel.touching.begin(), channel.touching.end());
    return channel;
  } catch (const ChannelEndCovered& covered) {
    throw ChannelEndCovered(covered.place_angstrom, order[covered.ball], covered.depth_angstrom);
  }
}

}  // namespace alphascope
