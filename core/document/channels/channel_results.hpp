// SPDX-License-Identifier: GPL-3.0-or-later
// Channels, and the points where they may begin and end, as derived results.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/cavity_shape/cavity_places.hpp"
#include "core/channel/channel.hpp"
#include "core/channel/ways_through.hpp"

namespace alphascope {

template <class T>
struct Definition;
struct CavityBottlenecks;
struct Inputs;

// Points where a channel from a cavity may begin and end: those of the largest clearance, for radii
// without the solvent.
struct CavityEnds {
  WidestPlace widest;
  std::vector<WidestPlace> mouths;  // in the order of Cavity::mouths
};

// Ends of the cavity with this deepest sink (ascending balls) in the table on screen. `found` is
// empty if the table has no such cavity.
struct FoundCavityEnds {
  std::array<BallIndex, 4> sink{};
  std::optional<CavityEnds> found;
};
Definition<FoundCavityEnds> cavity_ends(const std::array<BallIndex, 4>& sink);

// Facts on a channel that was found as a way through the molecule.
struct WayFacts {
  std::size_t number = 1;    // in the list; 1 is the best
  std::string through;       // "the whole molecule", "chains C, C-2", "chain A"
  double part_angstrom = 0;  // extent of `through` along the axis
  RealPoint axis;            // unit vector
  std::vector<std::string> lining_chains;
  // Numbers of balls inside that are not walls; widths are computed without them.
  std::size_t ions = 0, ligand_atoms = 0, other_atoms = 0;
};

// The answer to a request; it may contain no channel.
struct FoundChannel {
  std::shared_ptr<const BallSet> balls;
  ChannelEnds ends;
  std::optional<Channel> channel;
  // If set, an end of the channel lies in this ball, depth_angstrom below its surface.
  std::optional<BallIndex> covering;
  double depth_angstrom = 0;
  std::string why;                // reason why there is no channel; start of a sentence
  std::optional<WayFacts> way;    // if set, `ends` is the bottleneck and the axis, and was not
                                  // requested
  std::optional<WayCover> cover;  // only with a channel
  // Whether the channel is a way through, or leads through so much of the molecule that its
  // bottleneck tells what can pass the molecule.
  bool is_whole() const { return way || (cover && cover->is_whole()); }
};
// Inputs::balls and balls_key must be those without solvent, since the answer does not depend on
// alpha or the solvent radius. Runs on one thread.
Definition<FoundChannel> found_channel(const ChannelEnds& ends);

// The ways through a molecule, the best first. Only atoms of polymers are walls, so that ions and
// ligands in a pore do not narrow it. Without polymers all atoms are walls.
struct FoundWays {
  std::vector<std::shared_ptr<const FoundChannel>> ways;
  std::size_t parts_left_out = 0;  // number of chains that were not searched because there were too
                                   // many
};
// Ways through the whole, through groups of equal chains, and through each chain. Inputs::balls as
// for found_channel(). Requires Inputs::atoms. Throws as find_ways_through() does.
const Definition<FoundWays>& found_ways();

const Definition<CavityBottlenecks>& cavity_bottlenecks();

// Balls without solvent: the inverse of with_solvent().
BallSet without_solvent(const BallSet& grown, double solvent_radius_angstrom);
// The balls of Inputs::atoms; if these are not known, Inputs::balls without the solvent radius.
BallSet balls_without_solvent(const Inputs& in);

}  // namespace alphascope
