// SPDX-License-Identifier: GPL-3.0-or-later
// A small language that selects atoms, with the words of other programs:
//   chain A,B     resi 10-20,35,-3,12A     resn ALA,G*     name CA,C?     element C,Zn     altloc A
//   residue HEM   residue 10-20            index 12,20-30  copy 2         b > 40  occupancy < 1
//   protein nucleic polymer backbone sidechain water ligand ion hydrogen hetero all none
//   selected  hidden
//   within 5 of X      byres X      bychain X      not X      X and Y      X or Y      ( … )
// "not", "within … of", "byres" and "bychain" apply to the next word or parenthesis. They bind
// tighter than "and", which binds tighter than "or". Words may be in any case. "!", "&", "|" and
// some words of PyMOL are understood too. Names are compared as written in the file. In names * and
// ? stand for any characters. Names with blanks need double quotes. A residue number without a
// letter means all its insertion codes. Atoms (index) are counted from 1 in the file, and copies
// from 1 in the assembly.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "core/selection/picture_atoms.hpp"
#include "core/selection/selection_error.hpp"

namespace alphascope {

struct Atom;
struct Molecule;

// The reason why an expression cannot be understood without a picture; empty if it can.
std::optional<SelectionError> fault_of_selection(std::string_view text);

struct SelectionNode;

class SelectionExpression {
 public:
  // Throws SelectionError. A blank expression selects all.
  static SelectionExpression parse(std::string_view text);

  // The expression for one molecule, with names looked up and zones found. The molecule must
  // outlive it.
  class Bound {
   public:
    // `atom` must be an element of the molecule's atoms, not a copy
    bool operator()(const Atom& atom) const;

   private:
    friend class SelectionExpression;
    struct Node;
    std::shared_ptr<const std::vector<Node>> nodes_;
    const Molecule* molecule_ = nullptr;
  };
  // Distances are compared exactly, and only between atoms of one model, because the models of a
  // file overlap. A zone in a million atoms takes about 0.3 s; all else takes a few milliseconds.
  // Throws SelectionError for words that `picture` does not explain.
  Bound bind(const Molecule& molecule, const PictureAtoms& picture = {}) const;

 private:
  using Program = std::vector<SelectionNode>;
  struct Binder;
  std::shared_ptr<const Program> program_;  // null: all atoms
};

}  // namespace alphascope
