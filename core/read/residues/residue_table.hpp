// SPDX-License-Identifier: GPL-3.0-or-later
// The residues of a model, with the evidence of their atoms. decide_residues.hpp decides by it what
// they are.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "core/read/residues/atom_names.hpp"
#include "core/read/residues/residue_records.hpp"

namespace alphascope {

// Atoms by which residues are bound to each other or recognised.
enum class BackboneAtom : std::uint8_t { n, ca, c, p, o3, o5, c1, c3, c4, cb, other };
inline constexpr std::size_t kBackboneAtoms = 10;

inline constexpr std::uint32_t kNoIndex = std::numeric_limits<std::uint32_t>::max();

struct ResidueFacts {
  std::uint32_t first = 0;  // index of its first atom
  ResidueRecord record;
  ResidueFamily family = ResidueFamily::unknown;
  std::uint32_t atoms = 0;  // without dummies and sites of water; alternative locations count once
  // Counts among `atoms`. A guessed element counts as oxygen only for names of a water's oxygen,
  // and never as a metal.
  std::uint32_t oxygens = 0, hydrogens = 0, metals = 0, ions = 0, unknown = 0;
  std::uint32_t dummies = 0, sites = 0;
  bool hetero = true;  // all of its atoms are HETATM
  char letter = ' ';   // the alternative location that counts
  bool water_name = false;
  std::uint16_t has = 0;  // bits by BackboneAtom
  // Indices of the atoms at each kind of end: two each, for alternative locations.
  std::array<std::uint32_t, 2> n{kNoIndex, kNoIndex}, ca = n, c = n, p = n, o3 = n;

  bool holds(BackboneAtom atom) const { return (has >> static_cast<unsigned>(atom)) & 1; }
  bool amino_shape() const {
    return holds(BackboneAtom::n) && holds(BackboneAtom::ca) && holds(BackboneAtom::c);
  }
  bool nucleic_shape() const {
    return holds(BackboneAtom::c1) && holds(BackboneAtom::p) && holds(BackboneAtom::o5);
  }
  bool only_ca() const { return atoms == 1 && holds(BackboneAtom::ca); }
  // It can belong to a chain, by its name or its atoms.
  bool chain_like = false;
};

// Neighbouring atoms of one residue. Alternative residue types at one place may alternate in the
// file.
struct ResiduePiece {
  std::size_t begin = 0, end = 0;
  std::uint32_t residue = 0;
};

struct ResidueTable {
  std::vector<ResidueFacts> residues;  // in the order of their first atoms
  std::vector<ResiduePiece> pieces;    // together all named atoms of the model
};

// Roles of atoms by their names, found once for a molecule.
class AtomRoles {
 public:
  explicit AtomRoles(const Molecule& molecule);
  BackboneAtom backbone(NameId name) const { return backbone_[name]; }
  // True for a site without mass in a water, by its name, where the file states no element.
  bool is_water_site(const Molecule& molecule, const Atom& atom) const {
    if (!water_site_[atom.name] || atom.kind == ResidueKind::ion) return false;
    return atom.element == kUnknownElement || atom.element_guessed ||
           molecule.text(atom.name) == "OM";
  }
  ResidueFamily family(NameId residue_name);

 private:
  const NameTable& names_;
  std::vector<BackboneAtom> backbone_;
  std::vector<bool> water_site_;
  std::vector<std::optional<ResidueFamily>> families_;
};

// Takes time linear in the atoms of the model, whatever their order.
ResidueTable make_residue_table(const Molecule& molecule, const ModelRange& model,
                                const ResidueRecords& records, AtomRoles& roles);

}  // namespace alphascope
