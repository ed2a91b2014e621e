// References to atoms and simplices, sets of them, and what is selected.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

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

}  // namespace alphascope
