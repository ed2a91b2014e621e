// Cavities in the words of the molecule: what a cavity is called, and which residues line it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/cavity/cavity_table.hpp"
#include "core/cavity_identity/network_radius.hpp"
#include "core/document/reference/reference.hpp"

namespace alphascope {

// `references` are of the same balls without solvent radius, which have the same indices.

// The four atoms of the deepest sink, "A:LEU 24:CD1 A:ILE 50:O …". It stays while alpha moves and
// does not depend on the order of the table, so a paper can use it.
std::string cavity_name(const BallReferences& references, const CavityTable& table,
                        std::size_t row);
// The same of the balls of a sink.
std::string sink_name(const BallReferences& references, std::span<const BallIndex> sink);
// The same as a reference.
SimplexRef cavity_sink(const BallReferences& references, const CavityTable& table, std::size_t row);

struct LiningResidue {
  std::string address;           // "A:HIS 87"
  std::vector<BallIndex> balls;  // its atoms that line the cavity, ascending
  friend bool operator==(const LiningResidue&, const LiningResidue&) = default;
};

// In the order of the molecule.
std::vector<LiningResidue> lining_residues(const BallReferences& references,
                                           const CavityTable& table, std::size_t row);
// Of these balls, which ascend.
std::vector<LiningResidue> residues_of_lining(const BallReferences& references,
                                              std::span<const BallIndex> lining);
// How many those are, without their addresses.
struct LiningCounts {
  std::size_t residues = 0, chains = 0;
  std::size_t of_second = 0;  // residues of the chain that has the most but one

  // Between two chains, and not in one of which another is near: each has a fifth of the residues.
  bool at_interface() const { return chains == 2 && 5 * of_second >= residues; }
};
LiningCounts lining_counts(const BallReferences& references, const CavityTable& table,
                           std::size_t row);

// Sentences on what so many mouths mean; empty of one and of none.
std::string mouths_text(std::size_t mouths);
// Where it falls apart, as sentences.
std::string falls_apart_text(const NetworkEnd& end, double solvent_radius_angstrom);

}  // namespace alphascope
