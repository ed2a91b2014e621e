// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a molecule that are copies of each other. A property that distances decide, such as
// bonds and secondary structure, is the same in all copies and is computed once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/molecule/molecule.hpp"

namespace alphascope {

// Atoms [begin, end) of the first copy.
struct UnitPart {
  std::size_t begin = 0, end = 0;
  const CopiedAtoms* copied = nullptr;  // null for a molecule as deposited
  std::size_t size() const { return end - begin; }
  std::size_t of_copy(std::size_t atom, std::size_t copy) const { return atom + copy * size(); }
};

// Parts whose copies belong together, copy k of one with copy k of the other, because the same
// operators made them in the same order.
struct CopyUnit {
  std::vector<UnitPart> parts;  // ascending
  std::size_t copies = 1;

  std::size_t size() const;
  // The deposited atom of an atom of the first copy, by the part that has it.
  static std::size_t deposited(const UnitPart& part, std::size_t atom) {
    return part.copied == nullptr ? atom : part.copied->source[atom - part.begin];
  }
  // The atom of the first copy for a deposited atom; kNone if the unit does not have it.
  static constexpr std::uint32_t kNone = 0xffffffff;
  std::uint32_t atom_of(std::size_t deposited) const;
  // Every copy of an atom of the first copy is this many atoms behind the one before.
  const UnitPart& part_of(std::size_t atom) const;
};

// A molecule as deposited is one unit of one copy. The molecule must live longer.
std::vector<CopyUnit> copy_units(const Molecule& molecule, const ModelRange& model);

}  // namespace alphascope
