// SPDX-License-Identifier: GPL-3.0-or-later
// The solvent radius at which a network falls apart, found with new triangulations.
#pragma once

#include <memory>
#include <optional>
#include <string_view>

#include "core/geometry/alpha.hpp"
#include "core/predicates/flow_ties.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

struct BallSet;
struct CavityTable;
class TriangulationMaker;

// The stage name given to RunContext::progress.
inline constexpr std::string_view kNetworkStage = "where networks fall apart";

// Tested radii are multiples of the step (Å). They reach up to this much (Å) above the radius of
// the network.
inline constexpr double kNetworkStepAngstrom = 0.1, kNetworkReachAngstrom = 20;

struct NetworkEnd {
  // NetworkParting's alpha and its number of descendants. Empty: the network does not fall apart at
  // any alpha.
  std::optional<Alpha> alpha_angstrom2;
  std::size_t parts = 0;
  // With this solvent radius no cavity that came from the network (CavityMatch) is a network. One
  // step below there still is one, or the radius is not above the network's. Empty: there is a
  // network at all tested radii.
  std::optional<double> radius_angstrom;
  double largest_radius_angstrom = 0;      // upper end of the radii that may be tried
  std::size_t cavities = 0;                // number of cavities that came from the network
  double largest_volume_sa_angstrom3 = 0;  // the largest of these
  int triangulations = 0;                  // number of triangulations, the main cost
};

struct NetworkSearch {
  std::shared_ptr<TriangulationMaker> maker = {};  // of triangulations; null: the CPU
  int threads = 1;                                 // for each triangulation of CGAL
  FlowTies ties = FlowTies::perturbed;             // as for the ground of the table
};

// `cavity` is the index in table.found.cavities of a network. `balls` are those of the table
// without the solvent radius. Works in the caller's task arena; the result does not depend on the
// number of threads. Throws Cancelled, and std::invalid_argument if the cavity is not a network.
NetworkEnd find_network_end(const BallSet& balls, const CavityTable& table, std::uint32_t cavity,
                            const NetworkSearch& search = {}, const RunContext& context = {});

}  // namespace alphascope
