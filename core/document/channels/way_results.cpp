// SPDX-License-Identifier: GPL-3.0-or-later
// Ways through a molecule: parts to search, and the names of chains in the results.
#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "core/cavity_identity/cavity_identity.hpp"
#include "core/channel/by_place.hpp"
#include "core/document/channels/channel_results.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/store/definition.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/key.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/molecule/residue_kind.hpp"
#include "core/selection/prepare_balls.hpp"
#include "core/triangulation/flow.hpp"
#include "core/triangulation/memory_need.hpp"

namespace alphascope {
namespace {

struct NamedPart {
  std::string name;
  WayPart balls;  // indices into Walls::balls
};

// The balls between which ways are searched, and their indices among all balls.
struct Walls {
  BallSet balls;
  std::vector<BallIndex> original;
  std::vector<bool> is_wall;  // by index among all balls
};

Walls walls_of(const Molecule& molecule, const PreparedBalls& prepared) {
  const BallSet& all = *prepared.balls;
  Walls walls;
  walls.is_wall.assign(all.size(), false);
  const auto is_polymer = [&](BallIndex ball) {
    return molecule.atoms[prepared.atom_of_ball[ball]].kind == ResidueKind::polymer;
  };
  bool any = false;
  for (BallIndex ball = 0; ball < all.size() && !any; ++ball) any = is_polymer(ball);
  for (BallIndex ball = 0; ball < all.size(); ++ball) {
    if (any && !is_polymer(ball)) continue;
    walls.is_wall[ball] = true;
    walls.original.push_back(ball);
  }
  walls.balls = in_order(all, walls.original);
  return walls;
}

struct Chain {
  std::string name, sequence;
  WayPart balls;
};

// Chains in the order of the file.
std::vector<Chain> chains_of(const Molecule& molecule, const PreparedBalls& prepared,
                             const Walls& walls) {
  std::vector<Chain> chains;
  std::map<NameId, std::size_t> known;
  std::vector<const Atom*> last;
  for (BallIndex n = 0; n < walls.original.size(); ++n) {
    const Atom& atom = molecule.atoms[prepared.atom_of_ball[walls.original[n]]];
    const auto [at, first] = known.try_emplace(atom.chain, chains.size());
    if (first) {
      chains.push_back({std::string(molecule.text(atom.chain)), {}, {}});
      last.push_back(nullptr);
    }
    Chain& chain = chains[at->second];
    chain.balls.push_back(n);
    const Atom*& before = last[at->second];
    if (before == nullptr || !same_residue_number(*before, atom)) {
      chain.sequence += std::string(molecule.text(atom.residue_name)) + ' ';
    }
    before = &atom;
  }
  return chains;
}

std::string names_text(const std::vector<std::string>& names) {
  constexpr std::size_t kMostNamed = 8;
  std::string text;
  for (std::size_t n = 0; n < std::min(names.size(), kMostNamed); ++n) {
    text += (n > 0 ? ", " : "") + (names[n].empty() ? std::string("without a name") : names[n]);
  }
  return names.size() > kMostNamed ? text + "…" : text;
}

// The parts: the whole, each group of equal chains that is not the whole, and each of several
// chains.
std::vector<NamedPart> parts_of(const Walls& walls, const std::vector<Chain>& chains) {
  std::vector<NamedPart> parts(1);
  parts[0].name = "the whole molecule";
  for (BallIndex n = 0; n < walls.original.size(); ++n) parts[0].balls.push_back(n);
  if (chains.size() < 2) return parts;
  std::map<std::string, std::vector<const Chain*>> equal;
  for (const Chain& chain : chains) equal[chain.sequence].push_back(&chain);
  for (const auto& [sequence, group] : equal) {
    if (group.size() < 2 || group.size() == chains.size()) continue;
    NamedPart part;
    std::vector<std::string> names;
    for (const Chain* chain : group) {
      names.push_back(chain->name);
      part.balls.insert(part.balls.end(), chain->balls.begin(), chain->balls.end());
    }
    part.name = "chains " + names_text(names);
    parts.push_back(std::move(part));
  }
  for (const Chain& chain : chains) {
    parts.push_back({"chain " + names_text({chain.name}), chain.balls});
  }
  return parts;
}

std::vector<std::string> lining_chains(const std::vector<Chain>& chains,
                                       const std::vector<BallIndex>& lining) {
  std::vector<std::string> names;
  for (const Chain& chain : chains) {
    const bool lines = std::any_of(lining.begin(), lining.end(), [&](BallIndex ball) {
      return std::binary_search(chain.balls.begin(), chain.balls.end(), ball);
    });
    if (lines) names.push_back(chain.name);
  }
  return names;
}

// Counts balls that are not walls and that overlap the channel's spheres. An ion on the axis of an
// assembly occurs in every copy but is counted once.
void count_guests(const Molecule& molecule, const PreparedBalls& prepared, const Walls& walls,
                  const Channel& channel, WayFacts& note) {
  const BallSet& all = *prepared.balls;
  constexpr double kOnePlace = 0.5;  // Å; less than the distance of two atoms, more than the
                                     // rounding of copies
  std::vector<RealPoint> counted;
  for (BallIndex ball = 0; ball < all.size(); ++ball) {
    if (walls.is_wall[ball]) continue;
    const RealPoint centre = all.lattice.unit_angstrom() * real_point(all.centres[ball]);
    const double radius = all.lattice.angstrom(all.radii[ball]);
    const bool is_in = std::any_of(
        channel.samples.begin(), channel.samples.end(), [&](const ChannelSample& sample) {
          return length(sample.position_angstrom - centre) < sample.radius_angstrom + radius;
        });
    if (!is_in) continue;
    const bool again = std::any_of(counted.begin(), counted.end(), [&](const RealPoint& other) {
      return length(other - centre) < kOnePlace;
    });
    if (again) continue;
    counted.push_back(centre);
    const ResidueKind kind = molecule.atoms[prepared.atom_of_ball[ball]].kind;
    ++(kind == ResidueKind::ion      ? note.ions
       : kind == ResidueKind::ligand ? note.ligand_atoms
                                     : note.other_atoms);
  }
}

FoundWays find_ways(const Molecule& molecule, const PreparedBalls& prepared,
                    const RunContext& context) {
  const Walls walls = walls_of(molecule, prepared);
  const std::vector<Chain> chains = chains_of(molecule, prepared, walls);
  const std::vector<NamedPart> parts = parts_of(walls, chains);
  std::vector<WayPart> balls;
  for (const NamedPart& part : parts) balls.push_back(part.balls);
  WaysThrough through = find_ways_through(walls.balls, balls, context);
  FoundWays result;
  result.parts_left_out = through.parts_left_out;
  for (WayThrough& way : through.ways) {
    auto found = std::make_shared<FoundChannel>();
    found->balls = prepared.balls;
    WayFacts& note = found->way.emplace();
    note.number = result.ways.size() + 1;
    note.through = parts[way.part].name;
    note.part_angstrom = way.part_angstrom;
    note.axis = way.axis;
    note.lining_chains = lining_chains(chains, way.lining);
    found->cover = way.cover;
    found->channel = std::move(way.channel);
    for (BallIndex& ball : found->channel->touching) ball = walls.original[ball];
    count_guests(molecule, prepared, walls, *found->channel, note);
    found->ends = ChannelEnds::through(found->channel->narrowest().position_angstrom, way.axis);
    found->ends.end_radius_angstrom = found->channel->end_radius_angstrom;
    result.ways.push_back(std::move(found));
  }
  return result;
}

}  // namespace

const Definition<FoundWays>& found_ways() {
  static const Definition<FoundWays> definition{
      {.id = "channel.ways",
       .title = "Ways through the molecule",
       .key = [](const Inputs& in) { return in.atoms ? key_of_balls(in) : Key{}; },
       .memory =
           [](const Inputs& in) {
             // Bytes for the graph of tetrahedra and for searches at once, beside the
             // triangulation.
             constexpr std::uint64_t kWays = 2'000'000, kBytesOfBall = 2'000;
             return MemoryNeed{kWays, triangulation_memory(in.balls->size()).peak +
                                          kBytesOfBall * in.balls->size() + kWays};
           }},
      [](const Inputs& in, const RunContext& context) {
        return std::make_shared<const FoundWays>(
            find_ways(in.atoms->molecule(), in.atoms->prepared(), context));
      }};
  return definition;
}

}  // namespace alphascope
