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

#include "core/geometry/ball_set.hpp"
#include "core/selection/prepare_balls.hpp"
#include "core/selection/selection_expression.hpp"

namespace alphascope {

// An atom of the file, and which of its copies in the assembly (AtomSource).
struct AtomRef {
  std::uint32_t atom = 0, copy = 0;
  friend auto operator<=>(const AtomRef&, const AtomRef&) = default;
};

using SimplexRef = std::vector<AtomRef>;  // 1 to 4, ascending
using Ref = std::variant<AtomRef, SimplexRef>;

// A set of references. Every entry of the history has one, so copies share their content.
class RefSet {
 public:
  RefSet() = default;
  explicit RefSet(std::vector<Ref> refs);  // in any order

  const std::vector<Ref>& items() const;  // ascending, each once
  std::size_t size() const { return items().size(); }
  bool empty() const { return items().empty(); }
  bool contains(const Ref& ref) const;
  RefSet with(const std::vector<Ref>& refs) const;
  RefSet toggled(const Ref& ref) const;  // without it when it is there, else with it

  friend bool operator==(const RefSet& a, const RefSet& b) {
    return a.items_ == b.items_ || a.items() == b.items();
  }

 private:
  std::shared_ptr<const std::vector<Ref>> items_;  // null: none
};

struct Selection {
  RefSet items;
  // Chosen in the table of cavities, each by its deepest sink. Their lining atoms become `items`,
  // and both are in the history, so that undo brings back what belongs together.
  RefSet cavities;
  // More would make marks and history slow.
  static constexpr std::size_t kMostItems = 100000;

  bool empty() const { return items.empty() && cavities.empty(); }
  void clear() { items = cavities = {}; }

  // `items` has no order of its own. This notes which atoms were added since it was last called:
  // after each change of the selection, and once a frame.
  void note_order();
  // The selected atoms, those first that were selected first. The order of atoms that came at once,
  // or with many others, is that of the file. Not in the history.
  std::vector<AtomRef> atoms_in_order() const;

  // The same is selected, in whatever order.
  friend bool operator==(const Selection& a, const Selection& b) {
    return a.items == b.items && a.cavities == b.cavities;
  }

 private:
  // Nobody measures between more.
  static constexpr std::size_t kMostOrdered = 16;
  RefSet noted_;
  std::vector<AtomRef> order_;  // of noted_
};

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
