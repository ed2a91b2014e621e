// Which atoms of one model a user's choice takes as balls. Radii are not looked at here.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/selection/prepare_balls.hpp"
#include "core/selection/selection_expression.hpp"

namespace alphascope {

struct AtomRange {
  std::size_t begin, end;
};

// Decides atom by atom; what a whole residue decides (altlocs) is worked out at the start. Molecule
// and options must live longer.
class AtomFilter {
 public:
  AtomFilter(const Molecule& molecule, const BallOptions& options, AtomRange range,
             bool drop_hydrogens);

  // Of an atom of the range.
  std::optional<DropReason> reason_to_drop(std::size_t atom) const;
  // Whether it gives way to another of its alternative locations.
  bool is_minor_location(std::size_t atom) const {
    return !minor_.empty() && minor_[atom - range_.begin];
  }

 private:
  std::optional<DropReason> reason_not_picked(const Atom& atom) const;
  void choose_chains();

  const Molecule& molecule_;
  const BallOptions& options_;
  AtomRange range_;
  bool drop_hydrogens_;
  std::vector<bool> chains_;  // by name: whether the chain is kept; empty = all are
  std::optional<SelectionExpression::Bound> selection_;
  std::vector<bool> minor_;
};

}  // namespace alphascope
