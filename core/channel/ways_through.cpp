// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the ways through a molecule: candidates along each axis of each part, then the best as
// channels.
#include "core/channel/ways_through.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "core/channel/by_place.hpp"
#include "core/channel/centre_line.hpp"
#include "core/channel/envelope.hpp"
#include "core/channel/passage.hpp"
#include "core/channel/way_graph.hpp"
#include "core/channel/way_search.hpp"
#include "core/clearance/clearance.hpp"
#include "core/clearance/grown_triangulation.hpp"
#include "core/geometry/alpha.hpp"
#include "core/geometry/principal_axes.hpp"
#include "core/run/parallel.hpp"

namespace alphascope {
namespace {

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double length() const { return std::max(0.0, high - low); }
  Range within(const Range& other) const {
    return {std::max(low, other.low), std::min(high, other.high)};
  }
};

Range range_of(const BallSet& balls, const RealPoint& axis) {
  Range range;
  const double unit = balls.lattice.unit_angstrom();
  for (const LatticePoint& p : balls.centres) range.add(unit * dot(axis, real_point(p)));
  return range;
}

struct Candidate {
  std::size_t part = 0;
  RealPoint axis;
  WayCrossing crossing;
  WayRoute route;
  std::vector<std::uint32_t> tetrahedra;  // of the route, within the envelope; ascending
  // Share of the whole along the axis; length from corner to corner, Å.
  double share = 0, length = 0;
};

constexpr double kRounded = 0.01;  // Å, the rounding of the order of ways

class Finder {
 public:
  Finder(const BallSet& balls, const std::vector<WayPart>& parts, const RunContext& context)
      : balls_(balls),
        parts_(parts),
        clearance_(balls_),
        envelope_(balls_),
        context_(context),
        graph_(balls_, envelope_, context_) {}

  WaysThrough find();

 private:
  std::vector<RealPoint> axes_of(std::size_t part) const;  // whole_axes_, and the part's own
  double least_width() const;
  std::vector<Candidate> look_along(std::size_t part, const RealPoint& axis) const;
  bool is_too_narrow(const WayCrossing& crossing) const;
  void add(Candidate candidate);
  Candidate candidate(std::size_t part, const WayAxis& way, const WayCrossing& crossing,
                      const Range& whole, WaySearch& search) const;
  static bool are_one(const Candidate& a, const Candidate& b);
  static bool is_better(const Candidate& a, const Candidate& b);
  std::vector<RealPoint> curve_to(const RealPoint& place, const std::vector<std::uint32_t>& way,
                                  double end_radius) const;
  Channel channel_of(const Candidate& candidate) const;
  WayThrough finished(const Candidate& candidate) const;

  const BallSet& balls_;
  const std::vector<WayPart>& parts_;
  Clearance clearance_;
  Envelope envelope_;
  const RunContext& context_;
  const RunContext quiet_{context_.cancel, {}};  // for lines, which several threads make
  WayGraph graph_;
  std::vector<RealPoint> whole_axes_ = pore_axes(in_order(balls_, parts_[0]));
  std::vector<Candidate> found_;
};

// The axes of the whole. For another part also its own: the axis in which it is longest, or about
// which its centres spread alike.
std::vector<RealPoint> Finder::axes_of(std::size_t part) const {
  constexpr double kSame = 0.97;  // cosine of 14 degrees
  std::vector<RealPoint> axes = whole_axes_;
  if (part == 0) return axes;
  const RealPoint own = main_axis(in_order(balls_, parts_[part])).axis;
  const bool is_new = std::all_of(axes.begin(), axes.end(), [&](const RealPoint& axis) {
    return std::fabs(dot(axis, own)) < kSame;
  });
  if (is_new) axes.push_back(own);
  return axes;
}

// `whole` is the range of all centres along the axis.
Candidate Finder::candidate(std::size_t part, const WayAxis& way, const WayCrossing& crossing,
                            const Range& whole, WaySearch& search) const {
  Candidate result;
  result.part = part;
  result.axis = way.axis();
  result.crossing = crossing;
  result.route = search.route(crossing, context_.cancel);
  Range range;
  for (const auto* side : {&result.route.below, &result.route.above}) {
    RealPoint last = crossing.place_angstrom;
    range.add(way.along(last));
    for (const std::uint32_t t : *side) {
      range.add(way.along(graph_.corner(t)));
      if (graph_.is_outside(t)) continue;
      result.tetrahedra.push_back(t);
      result.length += length(graph_.corner(t) - last);
      last = graph_.corner(t);
    }
  }
  std::sort(result.tetrahedra.begin(), result.tetrahedra.end());
  if (whole.length() > 0) result.share = range.within(whole).length() / whole.length();
  return result;
}

bool Finder::are_one(const Candidate& a, const Candidate& b) {
  if (are_beside(a.crossing, b.crossing)) return true;
  std::vector<std::uint32_t> both;
  std::set_intersection(a.tetrahedra.begin(), a.tetrahedra.end(), b.tetrahedra.begin(),
                        b.tetrahedra.end(), std::back_inserter(both));
  return 2 * both.size() >= std::min(a.tetrahedra.size(), b.tetrahedra.size());
}

bool Finder::is_better(const Candidate& a, const Candidate& b) {
  const auto key = [](const Candidate& c) {
    const RealPoint& p = c.crossing.place_angstrom;
    return std::tuple(c.share < WayCover::kWholeShare, -std::round(100 * c.route.width_angstrom),
                      -c.length, p.x, p.y, p.z, c.part);
  };
  return key(a) < key(b);
}

// Returns whether so many wider ways are known already that the list has no room for this crossing,
// nor for any narrower one.
bool Finder::is_too_narrow(const WayCrossing& crossing) const {
  const auto wider = std::count_if(found_.begin(), found_.end(), [&](const Candidate& known) {
    return known.share >= WayCover::kWholeShare &&
           known.route.width_angstrom > crossing.width_angstrom + kRounded;
  });
  return static_cast<std::size_t>(wider) >= kMostWays;
}

// A width (Å) below which crossings are too narrow, now and whatever is found later. A known way
// gives way only to one at most kRounded narrower.
double Finder::least_width() const {
  std::vector<double> widths;
  for (const Candidate& known : found_) {
    if (known.share >= WayCover::kWholeShare) widths.push_back(known.route.width_angstrom);
  }
  if (widths.size() < kMostWays) return 0;
  std::nth_element(widths.begin(), widths.begin() + kMostWays - 1, widths.end(), std::greater<>());
  return widths[kMostWays - 1] - 3 * kRounded;
}

// Adds a candidate to found_, unless are_one() says that it is one with a known way. Of two such
// candidates the better one stays.
void Finder::add(Candidate candidate) {
  for (Candidate& known : found_) {
    if (!are_one(known, candidate)) continue;
    if (is_better(candidate, known)) known = std::move(candidate);
    return;
  }
  found_.push_back(std::move(candidate));
}

// The candidates of one search, the widest crossings first.
std::vector<Candidate> Finder::look_along(std::size_t part, const RealPoint& axis) const {
  constexpr std::size_t kMostTried = 12;
  const WayAxis way(balls_, parts_[part], axis);
  WaySearch search(graph_, way, kMostTried, least_width(), context_.cancel);
  const Range whole = range_of(balls_, axis);
  std::vector<Candidate> tried;
  for (const WayCrossing& crossing : search.crossings()) {
    tried.push_back(candidate(part, way, crossing, whole, search));
  }
  return tried;
}

// The curve from the bottleneck outwards, until it is wider than the end radius.
std::vector<RealPoint> Finder::curve_to(const RealPoint& place,
                                        const std::vector<std::uint32_t>& way,
                                        double end_radius) const {
  constexpr double kBeyond = 5;  // Å
  std::vector<RealPoint> curve{place};
  for (const std::uint32_t t : way) curve.push_back(graph_.corner(t));
  const RealPoint end = curve.back();
  if (clearance_.at(end) < end_radius + kBeyond) {
    curve.push_back(end + (end_radius + kBeyond) * envelope_.outwards(end));
  }
  return curve;
}

// The channel of a candidate. Its end radius is above the clearance anywhere on the route in the
// middle third of the part. So the line covers wide chambers as well.
Channel Finder::channel_of(const Candidate& candidate) const {
  constexpr double kWider = 1.02, kLeastEndRadius = 5;  // Å
  const WayCrossing& crossing = candidate.crossing;
  Channel channel;
  channel.triangulations = 1;
  channel.end_radius_angstrom =
      std::max(kLeastEndRadius, kEndOverBottleneck * crossing.width_angstrom);
  const WayAxis way(balls_, parts_[candidate.part], candidate.axis);
  for (const std::uint32_t t : candidate.tetrahedra) {
    if (way.zone(graph_.corner(t)) != 0) continue;
    channel.end_radius_angstrom =
        std::max(channel.end_radius_angstrom, kWider * clearance_.at(graph_.corner(t)));
  }
  CutCurve cut;
  cut.before =
      curve_to(crossing.place_angstrom, candidate.route.below, channel.end_radius_angstrom);
  std::reverse(cut.before.begin(), cut.before.end());
  cut.after = curve_to(crossing.place_angstrom, candidate.route.above, channel.end_radius_angstrom);
  set_channel_line(clearance_, envelope_, cut, false, false, channel, quiet_);
  for (std::size_t n = 0; n < channel.samples.size(); ++n) {
    if (channel.samples[n].radius_angstrom < channel.narrowest().radius_angstrom) {
      channel.bottleneck = n;
    }
  }
  const Lattice& lattice = balls_.lattice;
  channel.step_angstrom = lattice.angstrom(static_cast<double>(passage_step(lattice)));
  channel.widest_angstrom =
      std::floor(channel.narrowest().radius_angstrom / channel.step_angstrom) *
      channel.step_angstrom;
  set_touching(clearance_, channel);
  std::sort(channel.touching.begin(), channel.touching.end());
  return channel;
}

WayThrough Finder::finished(const Candidate& candidate) const {
  WayThrough way;
  way.part = candidate.part;
  way.axis = candidate.axis;
  way.channel = channel_of(candidate);
  Range line, part;
  constexpr double kLining = 0.5;  // Å
  std::vector<Surface> surfaces;
  for (const ChannelSample& sample : way.channel.samples) {
    line.add(dot(way.axis, sample.position_angstrom));
    clearance_.collect(sample.position_angstrom, sample.radius_angstrom + kLining, surfaces);
    for (const Surface& surface : surfaces) way.lining.push_back(surface.ball);
  }
  std::sort(way.lining.begin(), way.lining.end());
  way.lining.erase(std::unique(way.lining.begin(), way.lining.end()), way.lining.end());
  const Range whole = range_of(balls_, way.axis);
  for (const BallIndex ball : parts_[way.part]) {
    part.add(balls_.lattice.unit_angstrom() * dot(way.axis, real_point(balls_.centres[ball])));
  }
  way.cover = {line.within(whole).length(), whole.length()};
  way.part_angstrom = part.length();
  return way;
}

// Searches run in parallel, a few at a time. Their candidates are added in the order of parts and
// axes. The first searches are those of the whole: what they find makes the others shorter.
WaysThrough Finder::find() {
  constexpr std::size_t kAtATime = 8;
  struct Look {
    std::size_t part;
    RealPoint axis;
    std::vector<Candidate> tried;
  };
  WaysThrough result;
  const std::size_t parts = std::min(parts_.size(), kMostParts);
  result.parts_left_out = parts_.size() - parts;
  std::vector<Look> looks;
  for (std::size_t part = 0; part < parts; ++part) {
    for (const RealPoint& axis : axes_of(part)) looks.push_back({part, axis, {}});
  }
  for (std::size_t first = 0, end = whole_axes_.size(); first < looks.size();
       first = end, end = std::min(first + kAtATime, looks.size())) {
    parallel_each(first, end, [&](std::size_t n) {
      looks[n].tried = look_along(looks[n].part, looks[n].axis);
    });
    for (std::size_t n = first; n < end; ++n) {
      for (Candidate& next : std::exchange(looks[n].tried, {})) {
        if (is_too_narrow(next.crossing)) break;
        if (!next.route.below.empty() && !next.route.above.empty()) add(std::move(next));
      }
    }
    context_.report(kWaysStage, static_cast<double>(end) / static_cast<double>(looks.size()));
  }
  std::stable_sort(found_.begin(), found_.end(), is_better);
  found_.resize(std::min(found_.size(), kMostWays));
  result.ways.resize(found_.size());
  parallel_each(0, found_.size(), [&](std::size_t n) { result.ways[n] = finished(found_[n]); });
  return result;
}

}  // namespace

WaysThrough find_ways_through(const BallSet& balls, const std::vector<WayPart>& parts,
                              const RunContext& context) {
  const auto is_empty = [](const WayPart& part) { return part.empty(); };
  if (balls.size() == 0 || parts.empty() || std::any_of(parts.begin(), parts.end(), is_empty)) {
    throw std::invalid_argument("there are no balls, so there is no way through; select atoms");
  }
  const BallSet rounded = on_passage_lattice(balls, {});
  const std::vector<BallIndex> order = sorted_by_place(rounded);
  const BallSet sorted = in_order(rounded, order);
  std::vector<BallIndex> place(order.size());
  for (BallIndex n = 0; n < order.size(); ++n) place[order[n]] = n;
  std::vector<WayPart> sorted_parts;
  for (const WayPart& part : parts) {
    WayPart& next = sorted_parts.emplace_back();
    for (const BallIndex ball : part) next.push_back(place.at(ball));
    std::sort(next.begin(), next.end());
  }
  WaysThrough result = Finder(sorted, sorted_parts, context).find();
  for (WayThrough& way : result.ways) {
    for (std::vector<BallIndex>* list : {&way.channel.touching, &way.lining}) {
      for (BallIndex& ball : *list) ball = order[ball];
      std::sort(list->begin(), list->end());
    }
  }
  return result;
}

WayCover cover_of(const BallSet& balls, const Channel& channel) {
  const RealPoint begin = channel.samples.front().position_angstrom;
  RealPoint along = channel.samples.back().position_angstrom - begin;
  if (along == RealPoint{}) {  // for a closed line: towards its farthest place
    for (const ChannelSample& sample : channel.samples) {
      const RealPoint there = sample.position_angstrom - begin;
      if (length(there) > length(along)) along = there;
    }
  }
  if (along == RealPoint{}) return {};
  const RealPoint axis = unit_vector(along);
  Range line;
  for (const ChannelSample& sample : channel.samples) {
    line.add(dot(axis, sample.position_angstrom));
  }
  const Range whole = range_of(balls, axis);
  return {line.within(whole).length(), whole.length()};
}

}  // namespace alphascope
