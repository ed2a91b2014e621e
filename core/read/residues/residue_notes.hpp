// What is said of the residues of a file: which were guessed, and where evidence disagreed.
#pragma once

#include <map>
#include <string>

#include "core/molecule/molecule.hpp"

namespace alphascope {

class ResidueNotes {
 public:
  explicit ResidueNotes(Molecule& molecule) : molecule_(molecule) {}

  void guessed(ResidueReason why, std::size_t first_atom);
  // The entity table says one thing, and the atoms of the residue, which are asked for more,
  // another.
  void disagrees(const char* table_says, AtomKind kind, std::size_t first_atom);
  // The name of a water, and other atoms than one has.
  void no_water(std::size_t first_atom);

  void finish() const;

 private:
  struct Counted {
    std::size_t count = 0;
    std::string examples;  // addresses of the first few
  };
  void add(Counted& counted, std::size_t first_atom) const;

  Molecule& molecule_;
  std::map<ResidueReason, Counted> guesses_;
  std::map<std::pair<std::string, AtomKind>, Counted> disagreements_;
  Counted no_waters_;
};

}  // namespace alphascope
