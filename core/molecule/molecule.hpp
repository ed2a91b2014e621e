// SPDX-License-Identifier: GPL-3.0-or-later
// A molecule as its file describes it: atoms of all models on the decimal lattice, with their
// names. core/selection/prepare_balls.hpp chooses the atoms that become balls, and their radii.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/lattice.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/molecule/assembly.hpp"
#include "core/molecule/bond.hpp"
#include "core/molecule/element.hpp"
#include "core/molecule/name_table.hpp"
#include "core/molecule/residue_kind.hpp"
#include "core/molecule/residue_reason.hpp"
#include "core/molecule/secondary_structure.hpp"

namespace alphascope {

// Names are ids in Molecule::names. The size is 60 bytes, because an assembly may have 16 million
// atoms.
struct Atom {
  LatticePoint position;            // lattice units
  std::int32_t file_radius = -1;    // lattice units; 0: the file says so; -1: the file gives none
  std::int32_t serial = 0;          // 0: unknown
  std::int32_t residue_number = 0;  // the author's number
  std::uint32_t source_line = 0;    // counted from 1; 0: unknown
  float occupancy = 1;              // 1 if the file gives none
  float b_factor = 0;  // Å² (or see Molecule::has_confidences); 0 if the file gives none
  NameId name = 0;
  NameId residue_name = 0;
  NameId chain = 0;  // the author's name
  // The label_asym_id of mmCIF, to which assemblies refer; else the author's name.
  NameId label_chain = 0;
  Element element = kUnknownElement;
  ResidueKind kind = ResidueKind::polymer;
  char altloc = ' ';
  char insertion_code = ' ';
  bool hetero = false;                          // HETATM record in the file
  bool element_guessed : 1 = false;             // guessed from names that allow several elements
  bool has_b_factor : 1 = false;                // whether the file gives one
  ResidueReason why : 6 = ResidueReason::none;  // the reason for `kind`
  // The segment in columns 73-76 of a PDB file, numbered in order of appearance; 0: blank. Files of
  // several segments repeat chains and residue numbers.
  std::uint16_t segment = 0;
};

// Returns whether two atoms have the same chain, segment, residue number and insertion code in the
// file. Atoms of one residue do. Atoms of two residues do if the file runs out of numbers.
inline bool same_residue_number(const Atom& a, const Atom& b) {
  return a.residue_number == b.residue_number && a.chain == b.chain && a.segment == b.segment &&
         a.insertion_code == b.insertion_code;
}

// Returns whether two atoms can be there at once: alternative locations of different letters
// cannot.
inline bool may_meet(const Atom& a, const Atom& b) {
  return a.altloc == b.altloc || a.altloc == ' ' || b.altloc == ' ';
}

// Atoms [begin, end) of Molecule::atoms form one model.
struct ModelRange {
  int number = 1;  // number in the file
  std::size_t begin = 0, end = 0;
  std::size_t size() const { return end - begin; }
};

// Atoms of one model that were copied together for an assembly. Copy k of `source[j]` is
// Molecule::atoms[begin + k * source.size() + j].
struct CopiedAtoms {
  std::size_t begin = 0, copies = 0;
  std::vector<std::size_t> source;  // indices into the deposited molecule's atoms, ascending
  std::size_t generator = 0;        // index into Assembly::generators
};

struct Molecule {
  std::filesystem::path source;
  std::string format;  // "PDB", "mmCIF", "XYZR", "CRD"…
  std::string title;
  Lattice lattice;
  double rounding_angstrom = 0;    // largest change of a coordinate or radius by the lattice
  bool has_file_radii = false;     // whether any atom has a radius > 0 from the file
  bool has_confidences = false;    // B factors are confidences (pLDDT) of a predicted model
  std::vector<Atom> atoms;         // one model after another
  std::vector<ModelRange> models;  // at least one, none empty
  NameTable names;
  std::vector<std::string> notes;   // sentences on assumptions that the reader had to make
  Assemblies assemblies;            // as the file describes them
  std::string assembly_id;          // set by expand_assembly(); empty: as deposited
  std::vector<CopiedAtoms> copied;  // set by expand_assembly(), in the order of `atoms`; else empty
  // As the file states them, of all models, with indices of deposited atoms.
  std::vector<SecondaryRange> stated_secondary;
  std::vector<Bond> stated_bonds;  // ascending, each once
  // Records of bonds to atoms that are not in the file, or that share a number with others.
  std::size_t unresolved_bonds = 0;
  std::string sha256;  // of the file on disk, in hexadecimal digits

  std::string_view text(NameId id) const { return names.text(id); }
};

// An atom's name for people: "CA GLY 12A, chain B".
std::string atom_label(const Molecule& molecule, std::size_t atom);

// The deposited atom of which an atom is a copy, and the number of the copy. The number is 0 for
// the first copy and for every atom of a molecule as deposited. Copies of an atom are counted in
// the order of the assembly's generators, as in the chains' names. Copy 1 is in chain "A-2".
struct AtomSource {
  std::size_t deposited = 0, copy = 0;
};
AtomSource atom_source(const Molecule& molecule, std::size_t atom);
// The inverse of atom_source(). Empty if the assembly has no such copy, or the file no such atom.
std::optional<std::size_t> find_atom(const Molecule& molecule, const AtomSource& source);

}  // namespace alphascope
