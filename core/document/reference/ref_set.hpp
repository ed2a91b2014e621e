// SPDX-License-Identifier: GPL-3.0-or-later
// References to atoms and simplices, sets of them, and the selection.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

namespace alphascope {

// Index of an atom in the file, and number of its copy in the assembly (AtomSource).
struct AtomRef {
  std::uint32_t atom = 0, copy = 0;
  friend auto operator<=>(const AtomRef&, const AtomRef&) = default;
};

using SimplexRef = std::vector<AtomRef>;  // 1 to 4, ascending
using Ref = std::variant<AtomRef, SimplexRef>;

// A set of references. Copies share their content, because each entry of the history has one.
class RefSet {
 public:
  RefSet() = default;
  explicit RefSet(std::vector<Ref> refs);  // in any order

  const std::vector<Ref>& items() const;  // ascending, without duplicates
  std::size_t size() const { return items().size(); }
  bool empty() const { return items().empty(); }
  bool contains(const Ref& ref) const;
  RefSet with(const std::vector<Ref>& refs) const;
  RefSet toggled(const Ref& ref) const;  // without the reference if it is in the set, otherwise
                                         // with it

  friend bool operator==(const RefSet& a, const RefSet& b) {
    return a.items_ == b.items_ || a.items() == b.items();
  }

 private:
  std::shared_ptr<const std::vector<Ref>> items_;  // null: none
};

struct Selection {
  RefSet items;
  // Cavities selected in the table, each by its deepest sink. Their lining atoms become `items`.
  // The history contains both, so that undo restores them together.
  RefSet cavities;
  // A larger selection would slow down marks and history.
  static constexpr std::size_t kMostItems = 100000;

  bool empty() const { return items.empty() && cavities.empty(); }
  void clear() { items = cavities = {}; }

  // Notes which atoms were added since the last call. `items` is sorted and does not tell. Call it
  // after each change of the selection, and once a frame.
  void note_order();
  // The selected atoms in the order of their selection. Atoms that were added together, or to more
  // than kMostOrdered, have the order of the file. The order is not in the history.
  std::vector<AtomRef> atoms_in_order() const;

  // Compares the selections without their order.
  friend bool operator==(const Selection& a, const Selection& b) {
    return a.items == b.items && a.cavities == b.cavities;
  }

 private:
  // Atoms whose order is noted; a measurement needs at most four.
  static constexpr std::size_t kMostOrdered = 16;
  RefSet noted_;
  std::vector<AtomRef> order_;  // of noted_
};

}  // namespace alphascope
