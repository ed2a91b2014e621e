// SPDX-License-Identifier: GPL-3.0-or-later
// Joins, cuts and converts runs of atoms.
#include "core/document/reference/atom_set.hpp"

#include <algorithm>
#include <utility>

#include "core/document/reference/reference.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/selection/atom_address.hpp"

namespace alphascope {
namespace {

using Run = AtomSet::Run;

// Whether `b` begins inside `a` or directly after it. Requires a <= b.
bool touches(const Run& a, const Run& b) {
  return a.copy == b.copy && b.first <= std::uint64_t{a.last} + 1;
}

}  // namespace

AtomSet::AtomSet(std::vector<Run> runs) {
  std::sort(runs.begin(), runs.end());
  std::vector<Run> joined;
  for (const Run& run : runs) {
    if (!joined.empty() && touches(joined.back(), run)) {
      joined.back().last = std::max(joined.back().last, run.last);
    } else {
      joined.push_back(run);
    }
  }
  if (!joined.empty()) runs_ = std::make_shared<const std::vector<Run>>(std::move(joined));
}

const std::vector<AtomSet::Run>& AtomSet::runs() const {
  static const std::vector<Run> none;
  return runs_ ? *runs_ : none;
}

std::uint64_t AtomSet::size() const {
  std::uint64_t atoms = 0;
  for (const Run& run : runs()) atoms += std::uint64_t{run.last} - run.first + 1;
  return atoms;
}

bool AtomSet::contains(const AtomRef& atom) const {
  const auto after =
      std::upper_bound(runs().begin(), runs().end(), atom, [](const AtomRef& a, const Run& run) {
        return std::pair(a.copy, a.atom) < std::pair(run.copy, run.first);
      });
  if (after == runs().begin()) return false;
  const Run& run = *(after - 1);
  return run.copy == atom.copy && atom.atom <= run.last;
}

AtomSet AtomSet::with(const AtomSet& other) const {
  if (other.empty()) return *this;
  std::vector<Run> all = runs();
  all.insert(all.end(), other.runs().begin(), other.runs().end());
  return AtomSet(std::move(all));
}

AtomSet AtomSet::without(const AtomSet& other) const {
  std::vector<Run> left;
  auto cut = other.runs().begin();
  for (Run run : runs()) {
    const auto before = [&](const Run& c) {
      return c.copy < run.copy || (c.copy == run.copy && c.last < run.first);
    };
    while (cut != other.runs().end() && before(*cut)) ++cut;
    bool some = true;
    for (auto c = cut;
         some && c != other.runs().end() && c->copy == run.copy && c->first <= run.last; ++c) {
      if (c->first > run.first) left.push_back({run.copy, run.first, c->first - 1});
      some = c->last < run.last;
      if (some) run.first = c->last + 1;
    }
    if (some) left.push_back(run);
  }
  return AtomSet(std::move(left));
}

AtomSet atom_set(const Molecule& molecule, const std::vector<bool>& atoms) {
  std::vector<Run> runs;
  for (std::size_t i = 0; i < atoms.size(); ++i) {
    if (!atoms[i]) continue;
    const AtomSource source = atom_source(molecule, i);
    const auto copy = static_cast<std::uint32_t>(source.copy);
    const auto atom = static_cast<std::uint32_t>(source.deposited);
    if (!runs.empty() && runs.back().copy == copy && runs.back().last + 1 == atom) {
      runs.back().last = atom;
    } else {
      runs.push_back({copy, atom, atom});
    }
  }
  return AtomSet(std::move(runs));
}

std::vector<bool> atoms_of(const Molecule& molecule, const AtomSet& set) {
  std::vector<bool> atoms(molecule.atoms.size());
  if (set.empty()) return atoms;
  if (molecule.copied.empty()) {
    for (const Run& run : set.runs()) {
      if (run.copy != 0) break;
      const std::size_t end = std::min(atoms.size(), std::size_t{run.last} + 1);
      for (std::size_t i = run.first; i < end; ++i) atoms[i] = true;
    }
    return atoms;
  }
  for (std::size_t i = 0; i < atoms.size(); ++i) {
    const AtomSource source = atom_source(molecule, i);
    atoms[i] = set.contains(
        {static_cast<std::uint32_t>(source.deposited), static_cast<std::uint32_t>(source.copy)});
  }
  return atoms;
}

AtomSet all_atoms(const Molecule& molecule) {
  return atom_set(molecule, std::vector<bool>(molecule.atoms.size(), true));
}

AtomSet named_set(const Molecule& molecule, std::string_view text) {
  return named_set(molecule, text, {});
}

AtomSet named_set(const Molecule& molecule, std::string_view text, const PictureAtoms& picture) {
  const auto is_named = atoms_named(molecule, text, picture);
  std::vector<bool> atoms(molecule.atoms.size());
  for (std::size_t i = 0; i < atoms.size(); ++i) atoms[i] = is_named(i);
  return atom_set(molecule, atoms);
}

}  // namespace alphascope
