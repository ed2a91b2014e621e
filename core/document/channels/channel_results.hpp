// Channels and what they begin at, as derived results.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/cavity_shape/cavity_places.hpp"
#include "core/channel/bottlenecks.hpp"
#include "core/channel/channel.hpp"
#include "core/channel/ways_through.hpp"
#include "core/document/cavities/cavity_results.hpp"

namespace alphascope {

// Where a channel from a cavity may begin and end: the places of largest clearance, of radii
// without the solvent.
struct CavityEnds {
  WidestPlace widest;
  std::vector<WidestPlace> mouths;  // as Cavity::mouths
};
CavityEnds make_cavity_ends(const CavityGround& ground, const Cavity& cavity,
                            const BallSet& balls_as_they_are);

// Of the cavity with this deepest sink (ascending balls) in the table on screen. Null `found`: the
// table has none.
struct FoundCavityEnds {
  std::array<BallIndex, 4> sink{};
  std::optional<CavityEnds> found;
};
Definition<FoundCavityEnds> cavity_ends(const std::array<BallIndex, 4>& sink);

// What a channel is that was found as a way through the molecule.
struct WayNote {
  std::size_t number = 1;    // in the list; 1 is the best
  std::string through;       // "the whole molecule", "chains C, C-2", "chain A"
  double part_angstrom = 0;  // what `through` spans along the axis
  RealPoint axis;            // unit vector
  std::vector<std::string> lining_chains;
  // Balls in it, which are no walls: it is as wide as without them.
  std::size_t ions = 0, ligand_atoms = 0, other_atoms = 0;
};

// The answer to a question that may have none.
struct FoundChannel {
  std::shared_ptr<const BallSet> balls;
  ChannelEnds ends;
  std::optional<Channel> channel;
  // An end is in this ball, so far below its surface (Å).
  std::optional<BallIndex> covering;
  double depth_angstrom = 0;
  std::string why;                // there is no channel; the start of a sentence
  std::optional<WayNote> way;     // `ends` is then its bottleneck and axis, and was not asked
  std::optional<WayCover> cover;  // of a channel
  // Does it say anything about what passes the whole?
  bool is_whole() const { return way || (cover && cover->is_whole()); }
};
// Inputs::balls are those without a solvent, and balls_key is theirs: the answer depends on neither
// alpha nor the solvent radius. On one thread.
Definition<FoundChannel> found_channel(const ChannelEnds& ends);

// The ways through a molecule, the best first. What leads through is looked for between the atoms
// of polymers (of all, where there are none), since what lies in a pore is no part of it.
struct FoundWays {
  std::vector<std::shared_ptr<const FoundChannel>> ways;
  std::size_t parts_left_out = 0;  // chains that were not looked through, of too many
};
// Of the whole, of equal chains and of each chain. In the caller's task arena. Throws as
// find_ways_through().
FoundWays find_ways(const Molecule& molecule, const PreparedBalls& prepared,
                    const RunContext& context);
// Inputs::balls as for found_channel(), with Inputs::atoms.
const Definition<FoundWays>& found_ways();

// The narrowest places on the ways out of the cavities on screen, in the background.
struct CavityBottlenecks {
  // More would take minutes: each new value costs two triangulations.
  static constexpr std::size_t kMostRows = 100;
  std::vector<Bottleneck> rows;  // of the CavityTable's first rows, at most so many
};
const Definition<CavityBottlenecks>& cavity_bottlenecks();

// The balls that became `grown` by with_solvent().
BallSet without_solvent(const BallSet& grown, double solvent_radius_angstrom);

}  // namespace alphascope
