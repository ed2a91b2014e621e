// SPDX-License-Identifier: GPL-3.0-or-later
// Notes on the residues of a file: guesses, and evidence that disagrees.
#pragma once

#include <map>
#include <string>

#include "core/molecule/molecule.hpp"

namespace alphascope {

class ResidueNotes {
 public:
  explicit ResidueNotes(Molecule& molecule) : molecule_(molecule) {}

  void guessed(ResidueReason why, std::size_t first_atom);
  // The entity table contradicts the residue's own atoms, which take precedence.
  void disagrees(const char* table_says, ResidueKind kind, std::size_t first_atom);
  // A residue has a water's name, but atoms that a water does not have.
  void no_water(std::size_t first_atom);

  void finish() const;

 private:
  struct Counted {
    std::size_t count = 0;
    std::string examples;  // addresses of the first few residues
  };
  void add(Counted& counted, std::size_t first_atom) const;

  Molecule& molecule_;
  std::map<ResidueReason, Counted> guesses_;
  std::map<std::pair<std::string, ResidueKind>, Counted> disagreements_;
  Counted no_waters_;
};

}  // namespace alphascope
