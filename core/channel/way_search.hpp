// SPDX-License-Identifier: GPL-3.0-or-later
// A search for ways along one axis through a graph of tetrahedra. It finds the triangles where such
// ways are narrowest, and routes through these.
#pragma once

#include <cstdint>
#include <vector>

#include "core/channel/way_graph.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// A triangle at which a way is narrowest by power distance, with the tetrahedra on both sides.
struct WayCrossing {
  double width_angstrom = 0;  // clearance there
  float power = 0;
  RealPoint place_angstrom;
  std::uint32_t below = 0, above = 0;
};

// Returns whether both are in one passage, beside each other.
bool are_beside(const WayCrossing& a, const WayCrossing& b);

// A way from the outside below to the outside above. All tetrahedra but the first and last are
// within the envelope.
struct WayRoute {
  std::vector<std::uint32_t> below, above;  // each from the crossing on
  double width_angstrom = 0;                // least clearance, at the crossing or elsewhere
};

class WaySearch {
 public:
  // Searches for the `most` widest crossings of at least this clearance. The graph must outlive
  // this object. Throws Cancelled.
  WaySearch(const WayGraph& graph, const WayAxis& axis, std::size_t most, double least_angstrom,
            const CancelToken& cancel);

  // The crossings, the widest first. On both sides of a crossing the molecule lets a larger sphere
  // out. A ring of balls surrounds it, and its triangle alone closes it as the balls grow. Of
  // crossings beside each other only the widest counts.
  const std::vector<WayCrossing>& crossings() const { return crossings_; }

  // The route through a crossing. It is the way of least ∫ dl / clearance² that is nowhere narrower
  // by power distance than the crossing.
  WayRoute route(const WayCrossing& crossing, const CancelToken& cancel);

 private:
  void sweep(std::size_t most, double least_angstrom, const CancelToken& cancel);
  void find_unsettled(std::size_t first, std::size_t end, std::vector<std::uint32_t>& open) const;
  std::vector<WayCrossing> widest_apart(std::size_t most) const;
  bool is_settled(std::size_t most, double later_angstrom) const;
  void add_crossing(const WayRing& ring);
  bool may_pass(std::uint32_t from, std::uint32_t to) const;
  std::vector<std::uint32_t> way_out(std::uint32_t from, float power, const CancelToken& cancel);

  const WayGraph& graph_;
  WayAxis axis_;
  std::vector<std::int8_t> zone_;  // WayAxis::zone()
  // For each tetrahedron the side to which its widest way out leads: -1 below, 1 above, 0 none. It
  // is also 0 if that way is narrower than all crossings, because the sweep ended before.
  std::vector<std::int8_t> label_;
  std::vector<WayCrossing> crossings_;  // until the sweep ends, all found
  // Of the tetrahedra that way_out() has reached; elsewhere infinity, and not used.
  std::vector<double> least_;
  std::vector<std::uint32_t> before_;
};

}  // namespace alphascope
