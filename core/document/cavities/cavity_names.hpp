// SPDX-License-Identifier: GPL-3.0-or-later
// Names of cavities, and the residues that line them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/document/reference/ref_set.hpp"
#include "core/geometry/ball_index.hpp"

namespace alphascope {

class BallReferences;
struct CavityTable;
struct NetworkEnd;

// `references` refer to the same balls without solvent radius, which have the same indices.

// The four atoms of the deepest sink, "A:LEU 24:CD1 A:ILE 50:O …". The name does not change with
// alpha or with the order of the table, so a paper can use it.
std::string cavity_name(const BallReferences& references, const CavityTable& table,
                        std::size_t row);
// The name of a cavity with this sink.
std::string sink_name(const BallReferences& references, std::span<const BallIndex> sink);
// The deepest sink as a reference.
SimplexRef cavity_sink(const BallReferences& references, const CavityTable& table, std::size_t row);

struct LiningResidue {
  std::string address;           // "A:HIS 87"
  std::vector<BallIndex> balls;  // its atoms in the lining, ascending
  friend bool operator==(const LiningResidue&, const LiningResidue&) = default;
};

// Lining residues of a cavity, in the order of the molecule.
std::vector<LiningResidue> lining_residues(const BallReferences& references,
                                           const CavityTable& table, std::size_t row);
// The residues of these balls, which must ascend.
std::vector<LiningResidue> residues_of_lining(const BallReferences& references,
                                              std::span<const BallIndex> lining);
// Numbers of residues and chains in a lining.
struct LiningCounts {
  std::size_t residues = 0, chains = 0;
  std::size_t of_second = 0;  // residues of the chain with the second-most

  // Whether the cavity is at an interface of two chains: each has at least a fifth of the residues.
  bool at_interface() const { return chains == 2 && 5 * of_second >= residues; }
};
LiningCounts lining_counts(const BallReferences& references, const CavityTable& table,
                           std::size_t row);

// Sentences on the meaning of this number of mouths; empty for fewer than 2.
std::string mouths_text(std::size_t mouths);
// Sentences on the solvent radius and the alpha at which the network falls apart.
std::string falls_apart_text(const NetworkEnd& end, double solvent_radius_angstrom);

}  // namespace alphascope
