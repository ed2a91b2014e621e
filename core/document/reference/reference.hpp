// Atoms and simplices by a name that stays good when other atoms are used as balls. An index of a
// ball does not: it is another atom's as soon as hydrogens, alternative locations or the assembly
// change. So what outlives one set of balls (selection, history, session files) holds references
// only.
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
#include "core/geometry/ball_set.hpp"
#include "core/selection/prepare_balls.hpp"
#include "core/selection/selection_expression.hpp"

namespace alphascope {

// From the balls of one molecule under one set of options to references and back.
class BallReferences {
 public:
  BallReferences(std::shared_ptr<const Molecule> molecule,
                 std::shared_ptr<const PreparedBalls> prepared);

  AtomRef atom(BallIndex ball) const;
  AtomRef atom_of_molecule(std::size_t atom) const;  // an index into its atoms; need not be a ball
  // Of a simplex; one ball is an AtomRef.
  Ref reference(std::span<const BallIndex> balls) const;

  // Nothing when the atom is no ball under these options.
  std::optional<BallIndex> ball(const AtomRef& ref) const;
  // All balls of a reference, ascending; nothing when one of them is missing.
  std::optional<std::vector<BallIndex>> balls(const Ref& ref) const;

  const Molecule& molecule() const { return *molecule_; }
  const PreparedBalls& prepared() const { return *prepared_; }

 private:
  std::shared_ptr<const Molecule> molecule_;
  std::shared_ptr<const PreparedBalls> prepared_;
};

// One value an atom of the molecule: whether something of the set is of it, corners of simplices
// included. What the word "selected" of an expression means.
std::vector<bool> atoms_of(const Molecule& molecule, const RefSet& refs);

// "A:HIS 87:NE2", "edge A:HIS 87:CE1, A:HIS 87:NE2"; what the molecule lacks is left out.
std::string name_of(const Molecule& molecule, const Ref& ref);
// An expression that names these atoms and no others, however alike names are: "index 12,20", in an
// assembly "index 12 and copy 1 or index 20 and copy 2".
std::string expression_of(const Molecule& molecule, const Ref& ref);

struct NamedAtoms {
  std::vector<Ref> balls;  // of the atoms that are balls
  std::size_t others = 0;  // atoms that match and are none
};
// What an address or an expression names (core/selection/atom_address.hpp). Throws SelectionError.
NamedAtoms named_atoms(const BallReferences& references, std::string_view text,
                       const PictureAtoms& picture = {});

const char* simplex_kind_name(std::size_t corners);                  // of 1 to 4: "vertex", "edge"
std::string atom_text(const BallReferences& atoms, BallIndex ball);  // "A:VAL 1:CA"

}  // namespace alphascope
