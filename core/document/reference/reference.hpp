// SPDX-License-Identifier: GPL-3.0-or-later
// References to atoms and simplices that stay valid under other options. The index of a ball does
// not: it changes with hydrogens, alternative locations or the assembly. So data that outlive one
// set of balls (selection, history, session files) hold references only.
#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/document/reference/ref_set.hpp"
#include "core/geometry/ball_index.hpp"
#include "core/selection/picture_atoms.hpp"

namespace alphascope {

struct Molecule;
struct PreparedBalls;
class SecondaryOnce;

// Converts between balls of one molecule under one set of options and references.
class BallReferences {
 public:
  // `secondary`: of this molecule, shared with others; null: one of its own.
  BallReferences(std::shared_ptr<const Molecule> molecule,
                 std::shared_ptr<const PreparedBalls> prepared,
                 std::shared_ptr<SecondaryOnce> secondary = nullptr);

  AtomRef atom(BallIndex ball) const;
  AtomRef atom_of_molecule(std::size_t atom) const;  // index into the molecule's atoms; need not be
                                                     // a ball
  // Reference to a simplex; for one ball an AtomRef.
  Ref reference(std::span<const BallIndex> balls) const;

  // Empty if the atom is not a ball under these options.
  std::optional<BallIndex> ball(const AtomRef& ref) const;
  // All balls of a reference, ascending; empty if one of them is missing.
  std::optional<std::vector<BallIndex>> balls(const Ref& ref) const;

  const Molecule& molecule() const { return *molecule_; }
  const PreparedBalls& prepared() const { return *prepared_; }
  SecondaryOnce& secondary() const { return *secondary_; }

 private:
  std::shared_ptr<const Molecule> molecule_;
  std::shared_ptr<const PreparedBalls> prepared_;
  std::shared_ptr<SecondaryOnce> secondary_;
};

// A value for each atom of the molecule: whether it is in the set, or a corner of a simplex in it.
// The word "selected" of expressions uses this.
std::vector<bool> atoms_of(const Molecule& molecule, const RefSet& refs);

// "A:HIS 87:NE2", "edge A:HIS 87:CE1, A:HIS 87:NE2"; atoms that the molecule lacks are omitted.
std::string name_of(const Molecule& molecule, const Ref& ref);
// An expression that names exactly these atoms, even if others have the same names. Examples:
// "index 12,20"; for an assembly "index 12 and copy 1 or index 20 and copy 2".
std::string expression_of(const Molecule& molecule, const Ref& ref);

struct NamedAtoms {
  std::vector<Ref> balls;  // atoms that are balls
  std::size_t others = 0;  // number of other matching atoms
};
// Atoms named by an address or an expression (core/selection/atom_address.hpp). Throws
// SelectionError.
NamedAtoms named_atoms(const BallReferences& references, std::string_view text,
                       const PictureAtoms& picture = {});

const char* simplex_kind_name(std::size_t corners);                  // for 1 to 4 corners:
                                                                     // "vertex", "edge", …
std::string atom_text(const BallReferences& atoms, BallIndex ball);  // "A:VAL 1:CA"

}  // namespace alphascope
