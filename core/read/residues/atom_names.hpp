// Guessing what a name in a coordinate file means: elements from atom names, kinds of residues.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/molecule/molecule.hpp"
#include "core/read/residues/stated_element.hpp"

namespace alphascope {

// What is known of a residue by its name alone. One that may be an ion by its name (CLA, MG) is
// what its atoms' names make of it: see AtomGuesser.
enum class ResidueFamily : std::uint8_t { unknown, biopolymer, ligand, water, ion, dummy };
ResidueFamily residue_family(std::string_view residue_name);

// An unknown residue is a ligand when its atoms are HETATM, else part of a polymer; a known ligand
// is one either way, since many programs write ATOM only.
AtomKind atom_kind(ResidueFamily family, bool hetero);

// Where an atom's name stands in the four columns that the PDB format has for it. The symbol of the
// element ends in the second: "CA  " is calcium and " CA " carbon. Programs that do not know the
// rule begin in one column or the other with every name.
enum class NamePlace : std::uint8_t { second_column, first_column, free };  // free: no columns

// The place of a field of four columns.
NamePlace place_of(std::string_view field);

// An atom's element by its names (without blanks), for every reader; kUnknownElement if they say
// none. hetero: HETATM.
struct AtomNaming {
  std::string_view residue, atom;
  ResidueFamily family = ResidueFamily::unknown;
  NamePlace place = NamePlace::free;
  bool hetero = false;
};
Element guess_element(const AtomNaming& naming);

// Gives a reader's atoms their elements and says what their residues are.
class AtomGuesser {
 public:
  // Sets atom.element to what the file states, else guesses; the atom's names and hetero are set.
  // Returns what its residue is: an ion when the atom is one too.
  ResidueFamily identify(Atom& atom, std::optional<Element> stated, NamePlace place,
                         const NameTable& names);

  // The same with what the file's own column says (core/read/residues/stated_element.hpp). A
  // virtual site is of a dummy's residue; what is no element counts as none, and is said.
  ResidueFamily identify(Atom& atom, const StatedElement& stated, NamePlace place,
                         const NameTable& names);

  ResidueFamily family_of(NameId residue_name, const NameTable& names);

  // Says how many elements were guessed; `where_missing` is such as "because the file has no …".
  void add_note(Molecule& molecule, std::string_view where_missing) const;
  std::size_t guessed() const { return guessed_; }

 private:
  std::vector<std::optional<ResidueFamily>> families_;  // by NameId
  std::size_t guessed_ = 0, misstated_ = 0;
};

}  // namespace alphascope
