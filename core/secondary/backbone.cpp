// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the backbone atoms of residues by their names.
#include "core/secondary/backbone.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "core/molecule/altlocs.hpp"
#include "core/molecule/atom_type.hpp"

namespace alphascope {
namespace {

double distance_angstrom(const Molecule& molecule, std::uint32_t a, std::uint32_t b) {
  return length(position_angstrom(molecule, a) - position_angstrom(molecule, b));
}

// Å. The ring of proline closes with a bond of 1.47 Å from CD to N.
constexpr double kLongestRingBond = 1.9;

enum Role : std::uint8_t { kN, kCa, kC, kO, kOtherO, kCd, kRoles, kNoRole };

// The names of O at a chain's end are those of CHARMM and GROMOS. There OXT, OT2 and O2 are the
// other oxygen.
Role role_of(std::string_view name) {
  if (name == "N") return kN;
  if (name == "CA") return kCa;
  if (name == "C") return kC;
  if (name == "O") return kO;
  if (name == "OT1" || name == "OC1" || name == "O1") return kOtherO;
  return name == "CD" ? kCd : kNoRole;
}

class BackboneFinder {
 public:
  explicit BackboneFinder(const Molecule& molecule) : molecule_(molecule) {
    roles_.reserve(molecule.names.size());
    prolines_.reserve(molecule.names.size());
    for (NameId id = 0; id < molecule.names.size(); ++id) {
      roles_.push_back(role_of(molecule.text(id)));
      prolines_.push_back(standard_amino_acid(molecule.text(id)) == "PRO");
    }
  }

  std::vector<BackboneResidue> find(const CopyUnit& unit) {
    for (const UnitPart& part : unit.parts) take(part);
    close();
    find_chain_breaks(molecule_, residues_);
    return std::move(residues_);
  }

 private:
  void take(const UnitPart& part) {
    const auto& atoms = molecule_.atoms;
    const bool letters = std::any_of(atoms.begin() + static_cast<std::ptrdiff_t>(part.begin),
                                     atoms.begin() + static_cast<std::ptrdiff_t>(part.end),
                                     [](const Atom& atom) { return atom.altloc != ' '; });
    const std::vector<bool> minor =
        letters ? minor_altlocs(molecule_, part.begin, part.end) : std::vector<bool>();
    for (std::size_t i = part.begin; i < part.end; ++i) {
      const Atom& atom = atoms[i];
      if (atom.kind != ResidueKind::polymer || (letters && minor[i - part.begin])) continue;
      const Role role = roles_[atom.name];
      const bool again = role < kRoles && open_ && found_[role] != kNoAtom;
      if (!open_ || again || !same_residue_number(atoms[first_], atom)) begin(i);
      // The name of calcium is that of the alpha carbon.
      if (role < kRoles && !(role == kCa && is_metal(atom.element))) {
        found_[role] = static_cast<std::uint32_t>(i);
      }
    }
  }

  void begin(std::size_t i) {
    close();
    open_ = true;
    first_ = i;
    found_.fill(kNoAtom);
  }

  void close() {
    if (!open_) return;
    open_ = false;
    if (found_[kCa] == kNoAtom) return;
    BackboneResidue residue{static_cast<std::uint32_t>(first_), found_[kCa], found_[kN],
                            found_[kC]};
    residue.o = found_[kO] != kNoAtom ? found_[kO] : found_[kOtherO];
    residue.ring_at_nitrogen =
        prolines_[molecule_.atoms[first_].residue_name] ||
        (found_[kCd] != kNoAtom && found_[kN] != kNoAtom &&
         distance_angstrom(molecule_, found_[kCd], found_[kN]) <= kLongestRingBond);
    residues_.push_back(residue);
  }

  const Molecule& molecule_;
  std::vector<Role> roles_;     // by NameId
  std::vector<bool> prolines_;  // by NameId
  std::vector<BackboneResidue> residues_;
  bool open_ = false;  // whether a residue is being collected
  std::size_t first_ = 0;
  std::array<std::uint32_t, kRoles> found_{};
};

}  // namespace

std::vector<BackboneResidue> find_backbone(const Molecule& molecule, const CopyUnit& unit) {
  return BackboneFinder(molecule).find(unit);
}

void find_chain_breaks(const Molecule& molecule, std::vector<BackboneResidue>& residues) {
  for (std::size_t k = 0; k < residues.size(); ++k) {
    BackboneResidue& here = residues[k];
    here.bound_to_next = false;
    if (k + 1 == residues.size()) break;
    const BackboneResidue& next = residues[k + 1];
    const Atom &a = molecule.atoms[here.first], &b = molecule.atoms[next.first];
    if (a.chain != b.chain || a.segment != b.segment) continue;
    const bool has_bond = here.c != kNoAtom && next.n != kNoAtom;
    here.bound_to_next = has_bond
                             ? distance_angstrom(molecule, here.c, next.n) <= kLongestPeptideBond
                             : distance_angstrom(molecule, here.ca, next.ca) <= kLongestStep;
  }
}

}  // namespace alphascope
