// SPDX-License-Identifier: GPL-3.0-or-later
// Guesses elements from atom names, and families of residues from residue names.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/molecule/molecule.hpp"
#include "core/read/residues/stated_element.hpp"

namespace alphascope {

// The family of a residue by its name alone. If the name may be an ion's (CLA, MG), the names of
// its atoms decide: see AtomGuesser.
enum class ResidueFamily : std::uint8_t { unknown, biopolymer, ligand, water, ion, dummy };
ResidueFamily residue_family(std::string_view residue_name);

// An unknown residue is a ligand when its atoms are HETATM, else part of a polymer. A known ligand
// stays one, because many programs write only ATOM records.
ResidueKind residue_kind(ResidueFamily family, bool hetero);

// Where an atom's name begins in the four columns of the PDB format. The element's symbol ends in
// the second column: "CA  " is calcium and " CA " carbon. Programs that ignore this rule begin
// every name in the same column.
enum class NamePlace : std::uint8_t { second_column, first_column, free };  // free: no columns

// The place of a name in a field of four columns.
NamePlace place_of(std::string_view field);

// Names from which any reader gets an atom's element. They have no blanks. hetero: the record is
// HETATM.
struct AtomNaming {
  std::string_view residue, atom;
  ResidueFamily family = ResidueFamily::unknown;
  NamePlace place = NamePlace::free;
  bool hetero = false;
};
Element guess_element(const AtomNaming& naming);

// Sets the elements of a reader's atoms, and returns the families of their residues.
class AtomGuesser {
 public:
  // Sets atom.element to the stated element, else guesses it. Names and hetero must be set. Returns
  // the family of the residue. It is `ion` only when the atom is an ion too.
  ResidueFamily identify(Atom& atom, std::optional<Element> stated, NamePlace place,
                         const NameTable& names);

  // The same with the file's own column of elements (core/read/residues/stated_element.hpp). The
  // family of a virtual site is `dummy`. A text that is no element counts as none, and is noted.
  ResidueFamily identify(Atom& atom, const StatedElement& stated, NamePlace place,
                         const NameTable& names);

  ResidueFamily family_of(NameId residue_name, const NameTable& names);

  // Adds a note with the number of guessed elements. `where_missing` is such as "because the file
  // has no …".
  void add_note(Molecule& molecule, std::string_view where_missing) const;
  std::size_t guessed() const { return guessed_; }

 private:
  std::vector<std::optional<ResidueFamily>> families_;  // keys are NameId
  std::size_t guessed_ = 0, misstated_ = 0;
};

}  // namespace alphascope
