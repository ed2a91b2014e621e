// At which solvent radius a network falls apart: searched for with new triangulations.
#pragma once

#include <optional>
#include <string_view>

#include "core/cavity/cavity_table.hpp"

namespace alphascope {

// What RunContext::progress is told.
inline constexpr std::string_view kNetworkStage = "where networks fall apart";

// Radii that are tried are multiples of this, up to so much more than that of the network.
inline constexpr double kNetworkStepAngstrom = 0.1, kNetworkReachAngstrom = 20;

struct NetworkEnd {
  // As in NetworkParting, and how many cavities are left of it there. None: at no alpha.
  std::optional<Alpha> alpha_angstrom2;
  std::size_t parts = 0;
  // No cavity that came from it (CavityMatch) is a network with this solvent radius; one step below
  // there is one, or that is not above the radius of the network. None: it is one with all radii
  // that were tried.
  std::optional<double> radius_angstrom;
  double largest_radius_angstrom = 0;      // that may be tried
  std::size_t cavities = 0;                // that came from it
  double largest_volume_sa_angstrom3 = 0;  // of these
  int triangulations = 0;                  // what it cost
};

struct NetworkSearch {
  int threads = 1;                      // of each triangulation
  FlowTies ties = FlowTies::perturbed;  // as for the ground of the table
};

// `cavity`: an index of table.found.cavities that is a network; `balls`: those of the table without
// the solvent radius. Works in the caller's task arena; the same for any number of threads. Throws
// Cancelled, and std::invalid_argument where it is no network.
NetworkEnd find_network_end(const BallSet& balls, const CavityTable& table, std::uint32_t cavity,
                            const NetworkSearch& search = {}, const RunContext& context = {});

}  // namespace alphascope
