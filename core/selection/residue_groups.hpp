// What the residues of a molecule were taken for, one line for each name and decision, and by hand
// otherwise: the table from which people choose. Treatments name atoms, groups say what to name.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/molecule/molecule.hpp"
#include "core/selection/contents.hpp"
#include "core/selection/treatments.hpp"

namespace alphascope {

// Residues of one name that the file's evidence made the same for the same reason, and that are
// the same now.
struct ResidueGroup {
  std::string name;  // empty where the file gives none
  AtomKind kind = AtomKind::polymer;
  ResidueReason why = ResidueReason::none;  // `by_hand` where a treatment said so
  AtomKind file_kind = AtomKind::polymer;   // without treatments
  ResidueReason file_why = ResidueReason::none;
  std::size_t residues = 0, atoms = 0;
  std::size_t nth = 1;  // of the groups of this name, in the order of the list
  // What treatments call them: their name, or where others have the name as well the address of
  // each, or an expression that leaves out the others. Empty where they cannot be named: more than
  // kMostAddresses on both sides, points without matter, atoms of which the file gives nothing but
  // a chain.
  std::vector<std::string> called;
  std::vector<std::string> treated;  // the treatments in force that name any of them
  friend bool operator==(const ResidueGroup&, const ResidueGroup&) = default;
};

struct ResidueGroups {
  // Guesses of the file's reader first, then ligands, ions, dummies, waters, polymers, each by
  // name; treatments move no line.
  std::vector<ResidueGroup> of;
  KindCounts kinds{};       // residues; points without matter are none
  std::size_t guessed = 0;  // of them, still a guess
  std::size_t by_hand = 0;
};

inline constexpr std::size_t kMostAddresses = 50;

// Of the atoms [begin, end) of `molecule`, which was made of `deposited`: its assembly, treated.
// `treatments` are those that made `treated`. No groups where the format knows no residues.
ResidueGroups residue_groups(const Molecule& deposited, const Molecule& molecule, std::size_t begin,
                             std::size_t end, const std::vector<std::string>& treatments,
                             const TreatedAtoms& treated);

// "2 guessed, 1 set by hand", or where there are none "polymer 46 · water 58".
std::string decisions_text(const ResidueGroups& groups);

// "a polymer in the entity table"; for residues set by hand "set by hand; otherwise ligand (HETATM,
// and no part of a chain)".
std::string why_text(const ResidueGroup& group);

// An expression or addresses that select them; empty where `called` is.
std::string selection_text(const ResidueGroup& group);

// Say of them what they are, and take back every treatment that names any of them.
void treat_group(std::vector<std::string>& treatments, const ResidueGroup& group, AtomKind kind);
void take_back(std::vector<std::string>& treatments, const ResidueGroup& group);

}  // namespace alphascope
