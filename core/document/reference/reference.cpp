// SPDX-License-Identifier: GPL-3.0-or-later
// Sets of references, the order of selection, and lookups. Balls have the order of their atoms, so
// an atom's ball is found by bisection.
#include "core/document/reference/reference.hpp"

#include <algorithm>
#include <utility>

#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/radii/amber_radii.hpp"
#include "core/radii/radii_set.hpp"
#include "core/secondary/secondary_once.hpp"
#include "core/selection/atom_address.hpp"
#include "core/selection/prepare_balls.hpp"

namespace alphascope {

RefSet::RefSet(std::vector<Ref> refs) {
  std::sort(refs.begin(), refs.end());
  refs.erase(std::unique(refs.begin(), refs.end()), refs.end());
  if (!refs.empty()) items_ = std::make_shared<const std::vector<Ref>>(std::move(refs));
}

const std::vector<Ref>& RefSet::items() const {
  static const std::vector<Ref> none;
  return items_ ? *items_ : none;
}

bool RefSet::contains(const Ref& ref) const {
  return std::binary_search(items().begin(), items().end(), ref);
}

RefSet RefSet::with(const std::vector<Ref>& refs) const {
  std::vector<Ref> all = items();
  all.insert(all.end(), refs.begin(), refs.end());
  return RefSet(std::move(all));
}

RefSet RefSet::toggled(const Ref& ref) const {
  if (!contains(ref)) return with({ref});
  std::vector<Ref> others = items();
  others.erase(std::lower_bound(others.begin(), others.end(), ref));
  return RefSet(std::move(others));
}

void Selection::note_order() {
  if (items == noted_) return;
  noted_ = items;
  std::erase_if(order_, [&](const AtomRef& atom) { return !items.contains(atom); });
  if (items.size() > kMostOrdered) return;
  for (const Ref& item : items.items()) {
    const AtomRef* const atom = std::get_if<AtomRef>(&item);
    if (atom && std::find(order_.begin(), order_.end(), *atom) == order_.end()) {
      order_.push_back(*atom);
    }
  }
}

std::vector<AtomRef> Selection::atoms_in_order() const {
  Selection now = *this;
  now.note_order();
  if (items.size() <= kMostOrdered) return now.order_;
  std::vector<AtomRef> atoms;
  for (const Ref& item : items.items()) {
    if (const AtomRef* atom = std::get_if<AtomRef>(&item)) atoms.push_back(*atom);
  }
  return atoms;
}

BallReferences::BallReferences(std::shared_ptr<const Molecule> molecule,
                               std::shared_ptr<const PreparedBalls> prepared,
                               std::shared_ptr<SecondaryOnce> secondary)
    : molecule_(std::move(molecule)),
      prepared_(std::move(prepared)),
      secondary_(secondary ? std::move(secondary) : std::make_shared<SecondaryOnce>()) {}

AtomRef BallReferences::atom(BallIndex ball) const {
  return atom_of_molecule(prepared_->atom_of_ball.at(ball));
}

AtomRef BallReferences::atom_of_molecule(std::size_t atom) const {
  const AtomSource source = atom_source(*molecule_, atom);
  return {static_cast<std::uint32_t>(source.deposited), static_cast<std::uint32_t>(source.copy)};
}

Ref BallReferences::reference(std::span<const BallIndex> balls) const {
  if (balls.size() == 1) return atom(balls.front());
  SimplexRef simplex;
  for (const BallIndex ball : balls) simplex.push_back(atom(ball));
  std::sort(simplex.begin(), simplex.end());
  return simplex;
}

std::optional<BallIndex> BallReferences::ball(const AtomRef& ref) const {
  const auto atom = find_atom(*molecule_, {ref.atom, ref.copy});
  if (!atom) return std::nullopt;
  const std::vector<std::uint32_t>& atoms = prepared_->atom_of_ball;
  const auto at = std::lower_bound(atoms.begin(), atoms.end(), *atom);
  if (at == atoms.end() || *at != *atom) return std::nullopt;
  return static_cast<BallIndex>(at - atoms.begin());
}

std::optional<std::vector<BallIndex>> BallReferences::balls(const Ref& ref) const {
  std::vector<BallIndex> found;
  const auto add = [&](const AtomRef& atom) {
    const auto index = ball(atom);
    if (index) found.push_back(*index);
    return index.has_value();
  };
  if (const AtomRef* atom = std::get_if<AtomRef>(&ref)) {
    if (!add(*atom)) return std::nullopt;
  } else {
    for (const AtomRef& corner : std::get<SimplexRef>(ref)) {
      if (!add(corner)) return std::nullopt;
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<bool> atoms_of(const Molecule& molecule, const RefSet& refs) {
  std::vector<bool> atoms(molecule.atoms.size());
  const auto add = [&](const AtomRef& ref) {
    if (const auto atom = find_atom(molecule, {ref.atom, ref.copy})) atoms[*atom] = true;
  };
  for (const Ref& ref : refs.items()) {
    if (const AtomRef* atom = std::get_if<AtomRef>(&ref)) add(*atom);
    if (const SimplexRef* simplex = std::get_if<SimplexRef>(&ref)) {
      for (const AtomRef& corner : *simplex) add(corner);
    }
  }
  return atoms;
}

namespace {

std::vector<AtomRef> corners_of(const Ref& ref) {
  const AtomRef* const atom = std::get_if<AtomRef>(&ref);
  return atom ? std::vector<AtomRef>{*atom} : std::get<SimplexRef>(ref);
}

}  // namespace

std::string name_of(const Molecule& molecule, const Ref& ref) {
  const std::vector<AtomRef> corners = corners_of(ref);
  std::string names;
  for (const AtomRef& corner : corners) {
    const auto atom = find_atom(molecule, {corner.atom, corner.copy});
    if (atom) names += (names.empty() ? "" : ", ") + atom_address(molecule, *atom);
  }
  return corners.size() == 1 ? names : simplex_kind_name(corners.size()) + (" " + names);
}

std::string expression_of(const Molecule& molecule, const Ref& ref) {
  std::string text;
  for (const AtomRef& corner : corners_of(ref)) {
    const std::string index = std::to_string(std::uint64_t{corner.atom} + 1);
    if (molecule.copied.empty()) {
      text += (text.empty() ? "index " : ",") + index;
    } else {
      text += (text.empty() ? "" : " or ") + ("index " + index) + " and copy " +
              std::to_string(std::uint64_t{corner.copy} + 1);
    }
  }
  return text;
}

NamedAtoms named_atoms(const BallReferences& references, std::string_view text,
                       const PictureAtoms& picture) {
  const auto is_named = atoms_named(references.molecule(), text, picture);
  const std::vector<std::uint32_t>& atoms = references.prepared().atom_of_ball;
  NamedAtoms named;
  std::size_t ball = 0;
  for (std::size_t i = 0; i < references.molecule().atoms.size(); ++i) {
    const bool is_ball = ball < atoms.size() && atoms[ball] == i;
    if (is_named(i)) {
      if (is_ball) {
        named.balls.emplace_back(references.atom(static_cast<BallIndex>(ball)));
      } else {
        ++named.others;
      }
    }
    ball += is_ball;
  }
  return named;
}

const char* simplex_kind_name(std::size_t balls) {
  static constexpr const char* kKinds[] = {"vertex", "edge", "triangle", "tetrahedron"};
  return kKinds[std::clamp<std::size_t>(balls, 1, 4) - 1];
}

std::string atom_text(const BallReferences& atoms, BallIndex ball) {
  return atom_address(atoms.molecule(), atoms.prepared().atom_of_ball.at(ball));
}

}  // namespace alphascope
