// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the units of an assembly.
#include "core/molecule/copy_units.hpp"

#include <algorithm>

namespace alphascope {
namespace {

// Returns whether an atom was copied for both, so that their copies are of one chain.
bool overlap(const CopiedAtoms& a, const CopiedAtoms& b) {
  auto i = a.source.begin(), k = b.source.begin();
  while (i != a.source.end() && k != b.source.end()) {
    if (*i == *k) return true;
    *i < *k ? ++i : ++k;
  }
  return false;
}

}  // namespace

std::size_t CopyUnit::size() const {
  std::size_t atoms = 0;
  for (const UnitPart& part : parts) atoms += part.size();
  return atoms;
}

std::uint32_t CopyUnit::atom_of(std::size_t deposited) const {
  for (const UnitPart& part : parts) {
    if (part.copied == nullptr) {
      if (deposited >= part.begin && deposited < part.end) {
        return static_cast<std::uint32_t>(deposited);
      }
      continue;
    }
    const std::vector<std::size_t>& source = part.copied->source;
    const auto at = std::lower_bound(source.begin(), source.end(), deposited);
    if (at != source.end() && *at == deposited) {
      return static_cast<std::uint32_t>(part.begin + static_cast<std::size_t>(at - source.begin()));
    }
  }
  return kNone;
}

const UnitPart& CopyUnit::part_of(std::size_t atom) const {
  const auto next =
      std::upper_bound(parts.begin(), parts.end(), atom,
                       [](std::size_t a, const UnitPart& part) { return a < part.begin; });
  return *(next - 1);
}

std::vector<CopyUnit> copy_units(const Molecule& molecule, const ModelRange& model) {
  if (molecule.copied.empty()) return {{{{model.begin, model.end, nullptr}}, 1}};
  const auto& list = molecule.assemblies.list;
  const auto assembly = std::find_if(list.begin(), list.end(), [&](const Assembly& one) {
    return one.id == molecule.assembly_id;
  });
  const auto same_operators = [&](const CopiedAtoms& a, const CopiedAtoms& b) {
    if (assembly == list.end()) return false;
    const auto& generators = assembly->generators;
    return std::max(a.generator, b.generator) < generators.size() &&
           generators[a.generator].factors == generators[b.generator].factors;
  };
  std::vector<CopyUnit> units;
  for (const CopiedAtoms& copied : molecule.copied) {
    if (copied.begin < model.begin || copied.begin >= model.end) continue;
    const auto fits = std::find_if(units.begin(), units.end(), [&](const CopyUnit& unit) {
      return same_operators(*unit.parts.front().copied, copied) &&
             std::none_of(unit.parts.begin(), unit.parts.end(),
                          [&](const UnitPart& part) { return overlap(*part.copied, copied); });
    });
    CopyUnit& unit = fits == units.end() ? units.emplace_back() : *fits;
    unit.copies = copied.copies;
    unit.parts.push_back({copied.begin, copied.begin + copied.source.size(), &copied});
  }
  return units;
}

}  // namespace alphascope
