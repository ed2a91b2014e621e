// A molecule as its file gives it: atoms of all models on the decimal lattice, with their names.
// What is used of it, and with which radii, is decided in prepare_balls.hpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/lattice.hpp"
#include "core/molecule/assembly.hpp"
#include "core/molecule/element.hpp"
#include "core/molecule/name_table.hpp"
#include "core/molecule/residue_reason.hpp"

namespace alphascope {

// What an atom belongs to. Dummies are markers without matter, such as OPM's membrane planes.
enum class AtomKind : std::uint8_t { polymer, water, ligand, ion, dummy };

// Names are ids in Molecule::names. 60 bytes, since an assembly may have 16 million of them.
struct Atom {
  LatticePoint position;            // lattice units
  std::int32_t file_radius = -1;    // lattice units; 0 as the file says; -1 when it gives none
  std::int32_t serial = 0;          // 0 when unknown
  std::int32_t residue_number = 0;  // the author's
  std::uint32_t source_line = 0;    // counted from 1; 0 when unknown
  float occupancy = 1;              // 1 when the file gives none
  float b_factor = 0;  // Å², or see Molecule::has_confidences; 0 when the file gives none
  NameId name = 0;
  NameId residue_name = 0;
  NameId chain = 0;        // the author's
  NameId label_chain = 0;  // mmCIF's label_asym_id, which assemblies refer to; else the same
  Element element = kUnknownElement;
  AtomKind kind = AtomKind::polymer;
  char altloc = ' ';
  char insertion_code = ' ';
  bool hetero = false;                          // HETATM in the file
  bool element_guessed : 1 = false;             // from its names, which leave a choice
  bool has_b_factor : 1 = false;                // the file gives one
  ResidueReason why : 6 = ResidueReason::none;  // `kind` is what it is
  // Of a PDB file's columns 73-76, numbered in order of appearance; 0 where they are blank. Files
  // of several segments repeat chain and residue number.
  std::uint16_t segment = 0;
};

// Whether the file gives two atoms the same chain, segment, residue number and insertion code. It
// does so for atoms of one residue, and for those of two when it runs out of numbers.
inline bool same_residue_number(const Atom& a, const Atom& b) {
  return a.residue_number == b.residue_number && a.chain == b.chain && a.segment == b.segment &&
         a.insertion_code == b.insertion_code;
}

// Atoms [begin, end) of Molecule::atoms form one model.
struct ModelRange {
  int number = 1;  // as the file says
  std::size_t begin = 0, end = 0;
  std::size_t size() const { return end - begin; }
};

// Of an assembly, and of one model: atoms of the file that were copied together. Copy k of
// `source[j]` is Molecule::atoms[begin + k * source.size() + j].
struct CopiedAtoms {
  std::size_t begin = 0, copies = 0;
  std::vector<std::size_t> source;  // indices into the deposited molecule's atoms, ascending
};

struct Molecule {
  std::filesystem::path source;
  std::string format;  // "PDB", "mmCIF", "XYZR", "CRD"…
  std::string title;
  Lattice lattice;
  double rounding_angstrom = 0;    // largest change that the lattice made to a coordinate or radius
  bool has_file_radii = false;     // some atom has a radius > 0 from the file
  bool has_confidences = false;    // of a predicted model (pLDDT), in place of B factors
  std::vector<Atom> atoms;         // models one after another
  std::vector<ModelRange> models;  // at least one, none of them empty
  NameTable names;
  std::vector<std::string> notes;   // sentences: what the reader had to assume
  Assemblies assemblies;            // that the file describes
  std::string assembly_id;          // of expand_assembly(); empty = as deposited
  std::vector<CopiedAtoms> copied;  // by expand_assembly(), in the order of `atoms`; else empty
  std::string sha256;               // of the file as it lies on disk, in hexadecimal digits

  std::string_view text(NameId id) const { return names.text(id); }
};

// "CA GLY 12A, chain B": how an atom is named to people.
std::string atom_label(const Molecule& molecule, std::size_t atom);

// Which atom of the file an atom is a copy of, and which copy: 0 for the first, and for every atom
// of a molecule as deposited. Copies of one atom are counted in the order of the assembly's
// generators, as in the names of their chains: the chain of copy 1 is called "A-2".
struct AtomSource {
  std::size_t deposited = 0, copy = 0;
};
AtomSource atom_source(const Molecule& molecule, std::size_t atom);
// The other way round; nothing when this assembly has no such copy, or the file no such atom.
std::optional<std::size_t> find_atom(const Molecule& molecule, const AtomSource& source);

}  // namespace alphascope
