// SPDX-License-Identifier: GPL-3.0-or-later
// The choice of those atoms of a model that become balls. It does not consider radii.
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

// Decides on one atom at a time. Decisions on whole residues (alternative locations) are made by
// the constructor. Molecule and options must outlive this object.
class AtomFilter {
 public:
  AtomFilter(const Molecule& molecule, const BallOptions& options, AtomRange range,
             bool drop_hydrogens);

  // The reason to drop an atom of the range; empty: it is kept.
  std::optional<DropReason> reason_to_drop(std::size_t atom) const;
  // Returns whether the atom gives way to another of its alternative locations.
  bool is_minor_location(std::size_t atom) const {
    return !minor_.empty() && minor_[atom - range_.begin];
  }

 private:
  std::optional<DropReason> reason_not_selected(const Atom& atom) const;
  void choose_chains();

  const Molecule& molecule_;
  const BallOptions& options_;
  AtomRange range_;
  bool drop_hydrogens_;
  std::vector<bool> chains_;  // by name id: whether the chain is kept; empty: all chains are
  std::optional<SelectionExpression::Bound> selection_;
  std::vector<bool> minor_;
};

}  // namespace alphascope
