// SPDX-License-Identifier: GPL-3.0-or-later
// Joins tetrahedra by falling power, until those of ways from below and from above meet.
#include "core/channel/way_search.hpp"

#include <algorithm>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>

namespace alphascope {
namespace {

constexpr std::int8_t kNowhere = 2;  // a label: no step may lead into this tetrahedron
constexpr double kUnreached = std::numeric_limits<double>::infinity();

// Sets of joined tetrahedra.
class JoinedTetrahedra {
 public:
  explicit JoinedTetrahedra(std::uint32_t count) : nodes_(count) {
    for (std::uint32_t t = 0; t < count; ++t) nodes_[t] = {t, t};
  }
  std::uint32_t first_of(std::uint32_t t) {
    while (nodes_[t].parent != t) t = nodes_[t].parent = nodes_[nodes_[t].parent].parent;
    return t;
  }
  // Joins the sets of two different first tetrahedra.
  void join(std::uint32_t first, std::uint32_t second) {
    nodes_[std::max(first, second)].parent = std::min(first, second);
    std::swap(nodes_[first].next, nodes_[second].next);
  }
  template <class Visit>
  void visit_all(std::uint32_t t, const Visit& visit) const {
    std::uint32_t other = t;
    do {
      visit(other);
      other = nodes_[other].next;
    } while (other != t);
  }

 private:
  struct Node {
    std::uint32_t parent;
    std::uint32_t next;  // in a circle through all of a set
  };
  std::vector<Node> nodes_;
};

}  // namespace

bool are_beside(const WayCrossing& a, const WayCrossing& b) {
  constexpr double kNear = 3;  // Å
  return length(a.place_angstrom - b.place_angstrom) < kNear;
}

WaySearch::WaySearch(const WayGraph& graph, const WayAxis& axis, std::size_t most,
                     double least_angstrom, const CancelToken& cancel)
    : graph_(graph), axis_(axis), zone_(graph.size()), label_(graph.size(), 0) {
  for (std::uint32_t t = 0; t < graph.size(); ++t) {
    const RealPoint& corner = graph.corner(t);
    const int zone = axis_.zone(corner);
    zone_[t] = static_cast<std::int8_t>(zone);
    if (graph.is_outside(t)) {
      label_[t] = static_cast<std::int8_t>(axis_.side(corner));
    } else if (zone == 0 && !axis_.is_near(corner)) {
      label_[t] = kNowhere;
    }
  }
  sweep(most, least_angstrom, cancel);
  crossings_ = widest_apart(most);
}

std::vector<WayCrossing> WaySearch::widest_apart(std::size_t most) const {
  std::vector<WayCrossing> sorted = crossings_, result;
  std::sort(sorted.begin(), sorted.end(), [&](const WayCrossing& a, const WayCrossing& b) {
    const auto link = [&](const WayCrossing& c) { return graph_.link_to(c.below, c.above); };
    if (a.width_angstrom != b.width_angstrom) return a.width_angstrom > b.width_angstrom;
    return a.below != b.below ? a.below < b.below : link(a) < link(b);
  });
  for (const WayCrossing& crossing : sorted) {
    if (result.size() == most) break;
    const auto is_beside = [&](const WayCrossing& other) { return are_beside(other, crossing); };
    if (std::none_of(result.begin(), result.end(), is_beside)) result.push_back(crossing);
  }
  return result;
}

// Tests the whole segment between both corners, because they can be far apart.
bool WaySearch::may_pass(std::uint32_t from, std::uint32_t to) const {
  if (zone_[from] == zone_[to] && zone_[from] != 0) return true;
  return axis_.stays_near_axis(graph_.corner(from), graph_.corner(to));
}

// Each tetrahedron gets the label of the side from which the larger sphere reaches it. So faces are
// opened by falling power. The first face between a set without a label and one with a label gives
// it to the whole set. A crossing is a face where both labels meet. Of faces of equal power, that
// whose label comes from the wider way is first, so one tetrahedron between both sides counts to
// the wider one. The sweep ends when no face that is left can be among the crossings asked for.
void WaySearch::sweep(std::size_t most, double least_angstrom, const CancelToken& cancel) {
  constexpr std::size_t kTogether = 1024;
  struct Entry {
    std::uint32_t from, to;
  };
  const ResultArray<WayFace>& faces = graph_.faces();
  JoinedTetrahedra joined(graph_.size());
  std::vector<float> widest(graph_.size(), std::numeric_limits<float>::infinity());
  std::vector<Entry> entries;
  std::vector<std::uint32_t> open;
  auto ring = graph_.rings().begin();
  for (std::size_t first = 0, end = 0; first < faces.size(); first = end) {
    if (ring == graph_.rings().end() || ring->widest_angstrom < least_angstrom) return;
    cancel.throw_if_cancelled();
    if (is_settled(most, ring->widest_angstrom)) return;
    end = std::min(first + kTogether, faces.size());
    while (end < faces.size() && faces[end].power == faces[end - 1].power) ++end;
    find_unsettled(first, end, open);
    for (std::size_t n = 0; n < open.size();) {
      const float power = faces[open[n]].power;
      entries.clear();
      for (; n < open.size() && faces[open[n]].power == power; ++n) {
        const std::uint32_t a = faces[open[n]].a, b = faces[open[n]].b;
        const std::int8_t at_a = label_[a], at_b = label_[b];
        if (at_a != 0 && at_b != 0) continue;
        if (at_a != 0 || at_b != 0) {
          const Entry entry = at_a != 0 ? Entry{a, b} : Entry{b, a};
          if (may_pass(entry.from, entry.to)) entries.push_back(entry);
        } else {
          const std::uint32_t first_a = joined.first_of(a), first_b = joined.first_of(b);
          if (first_a != first_b && may_pass(a, b)) joined.join(first_a, first_b);
        }
      }
      if (entries.size() > 1) {
        std::sort(entries.begin(), entries.end(), [&](const Entry& a, const Entry& b) {
          return std::tie(widest[a.from], a.from, a.to) > std::tie(widest[b.from], b.from, b.to);
        });
      }
      for (const Entry& entry : entries) {
        if (label_[entry.to] != 0) continue;
        joined.visit_all(entry.to, [&](std::uint32_t t) {
          label_[t] = label_[entry.from];
          widest[t] = power;
        });
      }
    }
    // Both sides of a face that was opened have their labels now, or will get the same one.
    for (; ring != graph_.rings().end() && ring->face < end; ++ring) {
      if (ring->clearance_angstrom >= least_angstrom) add_crossing(*ring);
    }
  }
}

// Sets `open` to those of the faces [first, end) that may still give a label or join tetrahedra.
// Labels stay, so no other face matters. The loop has no branch: more than half of the faces are
// left out, and which ones is hard to predict.
void WaySearch::find_unsettled(std::size_t first, std::size_t end,
                               std::vector<std::uint32_t>& open) const {
  const ResultArray<WayFace>& faces = graph_.faces();
  open.resize(end - first);
  std::size_t count = 0;
  for (std::size_t n = first; n < end; ++n) {
    const std::int8_t a = label_[faces[n].a], b = label_[faces[n].b];
    open[count] = static_cast<std::uint32_t>(n);
    count += static_cast<std::size_t>(((a == 0) & (b != kNowhere)) | ((b == 0) & (a != kNowhere)));
  }
  open.resize(count);
}

// Returns whether crossings no wider than this change nothing about the widest ones.
bool WaySearch::is_settled(std::size_t most, double later_angstrom) const {
  const auto is_wider = [&](const WayCrossing& c) { return c.width_angstrom > later_angstrom; };
  const auto wider = std::count_if(crossings_.begin(), crossings_.end(), is_wider);
  if (static_cast<std::size_t>(wider) < most) return false;
  const std::vector<WayCrossing> widest = widest_apart(most);
  return widest.size() == most && widest.back().width_angstrom > later_angstrom;
}

// Adds the crossing at this ring if labels from both sides meet there.
void WaySearch::add_crossing(const WayRing& ring) {
  const WayFace& face = graph_.faces()[ring.face];
  if (label_[face.a] == 0 || label_[face.a] != -label_[face.b]) return;
  WayCrossing crossing;
  crossing.below = label_[face.a] < 0 ? face.a : face.b;
  crossing.above = label_[face.a] < 0 ? face.b : face.a;
  if (!may_pass(crossing.below, crossing.above)) return;
  crossing.power = face.power;
  crossing.width_angstrom = ring.clearance_angstrom;
  const std::size_t link = graph_.link_to(crossing.below, crossing.above);
  crossing.place_angstrom = graph_.gap_at(crossing.below, link).place_angstrom;
  crossings_.push_back(crossing);
}

std::vector<std::uint32_t> WaySearch::way_out(std::uint32_t from, float power,
                                              const CancelToken& cancel) {
  using Entry = std::pair<double, std::uint32_t>;
  least_.resize(graph_.size(), kUnreached);
  before_.resize(graph_.size());
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  std::vector<std::uint32_t> reached, way;
  const auto reach = [&](std::uint32_t t, std::uint32_t before, double least) {
    if (least_[t] == kUnreached) reached.push_back(t);
    least_[t] = least;
    before_[t] = before;
    open.push({least, t});
  };
  reach(from, WayGraph::kNothing, 0);
  for (std::size_t steps = 0; !open.empty(); ++steps) {
    if (steps % 1024 == 0) cancel.throw_if_cancelled();
    const auto [own, t] = open.top();
    open.pop();
    if (own > least_[t]) continue;
    if (graph_.is_outside(t)) {
      way = {t};
      while (before_[way.back()] != WayGraph::kNothing) way.push_back(before_[way.back()]);
      std::reverse(way.begin(), way.end());
      break;
    }
    for (std::size_t k = 0; k < 4; ++k) {
      const WayGraph::Link& link = graph_.links(t)[k];
      if (link.to == WayGraph::kNothing || link.power < power) continue;
      if (least_[link.to] <= own) continue;
      if (label_[link.to] != label_[from] || !may_pass(t, link.to)) continue;
      const double next = own + graph_.cost_across(t, k);
      if (next < least_[link.to]) reach(link.to, t, next);
    }
  }
  for (const std::uint32_t t : reached) least_[t] = kUnreached;
  return way;
}

WayRoute WaySearch::route(const WayCrossing& crossing, const CancelToken& cancel) {
  WayRoute route{way_out(crossing.below, crossing.power, cancel),
                 way_out(crossing.above, crossing.power, cancel), crossing.width_angstrom};
  for (const auto* way : {&route.below, &route.above}) {
    for (std::size_t n = 1; n < way->size(); ++n) {
      const WayGraph::Link& link =
          graph_.links((*way)[n - 1])[graph_.link_to((*way)[n - 1], (*way)[n])];
      route.width_angstrom = std::min(route.width_angstrom, static_cast<double>(link.gap_angstrom));
    }
  }
  return route;
}

}  // namespace alphascope
