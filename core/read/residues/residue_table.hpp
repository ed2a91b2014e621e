// The residues of a model with what their atoms tell of them: the first half of deciding what they
// are (decide_residues.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "core/read/residues/atom_names.hpp"
#include "core/read/residues/residue_records.hpp"

namespace alphascope {

// Atoms by which residues are bound to each other or known.
enum class BackboneAtom : std::uint8_t { n, ca, c, p, o3, o5, c1, c3, c4, cb, other };
inline constexpr std::size_t kBackboneAtoms = 10;

inline constexpr std::uint32_t kNoIndex = std::numeric_limits<std::uint32_t>::max();

struct ResidueFacts {
  std::uint32_t first = 0;  // its first atom
  ResidueRecord record;
  ResidueFamily family = ResidueFamily::unknown;
  std::uint32_t atoms = 0;  // without dummies and water's sites; alternatives count once
  // Of them; an element that is guessed from a name counts as oxygen for a water's names only, and
  // not as a metal.
  std::uint32_t oxygens = 0, hydrogens = 0, metals = 0, ions = 0, unknown = 0;
  std::uint32_t dummies = 0, sites = 0;
  bool hetero = true;  // all of its atoms are HETATM
  char letter = ' ';   // the alternative location that counts
  bool water_name = false;
  std::uint16_t has = 0;  // bits by BackboneAtom
  // Where the atoms of each kind of end are; two, for alternative locations.
  std::array<std::uint32_t, 2> n{kNoIndex, kNoIndex}, ca = n, c = n, p = n, o3 = n;

  bool holds(BackboneAtom atom) const { return (has >> static_cast<unsigned>(atom)) & 1; }
  bool amino_shape() const {
    return holds(BackboneAtom::n) && holds(BackboneAtom::ca) && holds(BackboneAtom::c);
  }
  bool nucleic_shape() const {
    return holds(BackboneAtom::c1) && holds(BackboneAtom::p) && holds(BackboneAtom::o5);
  }
  bool only_ca() const { return atoms == 1 && holds(BackboneAtom::ca); }
  // Something that chains are made of, by its name or its atoms.
  bool chain_like = false;
};

// Neighbouring atoms of one residue. Alternative residue types of one place may take turns.
struct ResiduePiece {
  std::size_t begin = 0, end = 0;
  std::uint32_t residue = 0;
};

struct ResidueTable {
  std::vector<ResidueFacts> residues;  // in the order of their first atoms
  std::vector<ResiduePiece> pieces;    // cover the model's named atoms
};

// What a name's characters tell; made once for a molecule.
class AtomRoles {
 public:
  explicit AtomRoles(const Molecule& molecule);
  BackboneAtom backbone(NameId name) const { return backbone_[name]; }
  // Of a water's atom without matter, where no element is known.
  bool is_water_site(const Molecule& molecule, const Atom& atom) const {
    if (!water_site_[atom.name] || atom.kind == AtomKind::ion) return false;
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

// In time that grows with the atoms of the model, whatever their order.
ResidueTable make_residue_table(const Molecule& molecule, const ModelRange& model,
                                const ResidueRecords& records, AtomRoles& roles);

}  // namespace alphascope
