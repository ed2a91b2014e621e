// SPDX-License-Identifier: GPL-3.0-or-later
// Chooses the atoms and bonds, and makes their balls and sticks.
#include "ui/scene/mesh/beside_body.hpp"

#include <algorithm>
#include <array>

#include "core/geometry/alpha.hpp"
#include "core/molecule/atom_colours.hpp"

namespace alphascope {
namespace {

// Å, as drawn. Balls of the body are drawn with 0.3 of their radius, about 0.5 Å.
constexpr float kBall = 0.34f, kHydrogenBall = 0.2f, kWaterBall = 0.42f, kIonBall = 0.8f;
constexpr double kStick = 0.13;  // Å
// Most sticks that are drawn. With more, no single bond could be seen, and they would take hundreds
// of megabytes.
constexpr std::size_t kMostSticks = 30000;

float drawn_radius(DropReason reason, Element element) {
  if (element == kHydrogen) return kHydrogenBall;
  if (reason == DropReason::water) return kWaterBall;
  return reason == DropReason::ion ? kIonBall : kBall;
}

class Builder {
 public:
  Builder(const BallGeometry& balls, const Molecule& molecule, const AtomsBesideBody& shown)
      : origin_(balls.origin), molecule_(molecule), shown_(shown) {
    spheres_.origin = balls.origin;
  }

  BesideBody build(const std::vector<LeftOutAtom>& left_out, std::span<const Bond> bonds,
                   const CancelToken& cancel) {
    for (const LeftOutAtom& a : left_out) {
      const Element element = molecule_.atoms[a.atom].element;
      if (!shows(shown_, a.reason, element)) continue;
      atoms_.push_back(a);
      const RealPoint p = place(a.atom);
      spheres_.centres.push_back(
          {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
      spheres_.radii.push_back(drawn_radius(a.reason, element));
      mesh_.opaque.sphere_colours.push_back(element_colour(element));
    }
    if (atoms_.empty()) return {};
    cancel.throw_if_cancelled();
    choose_bonds(bonds);
    cancel.throw_if_cancelled();
    if (bonds_.size() <= kMostSticks) add_sticks();
    mesh_.opaque.spheres = std::make_shared<const BallGeometry>(std::move(spheres_));
    return {std::make_shared<const LayerMesh>(std::move(mesh_)), std::move(atoms_)};
  }

 private:
  // Å, relative to the origin of the balls.
  RealPoint place(std::uint32_t atom) const {
    const LatticePoint& p = molecule_.atoms[atom].position;
    const Lattice& l = molecule_.lattice;
    return {l.angstrom(p.x) - origin_[0], l.angstrom(p.y) - origin_[1],
            l.angstrom(p.z) - origin_[2]};
  }

  bool is_drawn(std::uint32_t atom) const {
    const auto at =
        std::lower_bound(atoms_.begin(), atoms_.end(), atom,
                         [](const LeftOutAtom& a, std::uint32_t i) { return a.atom < i; });
    return at != atoms_.end() && at->atom == atom;
  }

  // Keeps bonds between atoms that are drawn here, and those of hydrogens to the body.
  void choose_bonds(std::span<const Bond> bonds) {
    const auto is_hydrogen = [&](std::uint32_t i) {
      return molecule_.atoms[i].element == kHydrogen;
    };
    for (const Bond& bond : bonds) {
      const bool a = is_drawn(bond.a), b = is_drawn(bond.b);
      if ((a && b) || (a && is_hydrogen(bond.a)) || (b && is_hydrogen(bond.b))) {
        bonds_.push_back({bond.a, bond.b});
      }
    }
  }

  // Each half of a stick has the colour of its atom.
  void add_sticks() {
    for (const auto& [a, b] : bonds_) {
      const RealPoint p = place(a), q = place(b), middle = 0.5 * (p + q);
      add_stick(p, middle, kStick, element_colour(molecule_.atoms[a].element), mesh_.tubes);
      add_stick(middle, q, kStick, element_colour(molecule_.atoms[b].element), mesh_.tubes);
    }
  }

  const std::array<double, 3> origin_;
  const Molecule& molecule_;
  const AtomsBesideBody& shown_;
  BallGeometry spheres_;
  LayerMesh mesh_;
  std::vector<LeftOutAtom> atoms_;
  std::vector<std::array<std::uint32_t, 2>> bonds_;
};

}  // namespace

BesideBody build_beside_body(const BallGeometry& balls, const Molecule& molecule,
                             const PreparedBalls& prepared, std::span<const Bond> bonds,
                             const AtomsBesideBody& shown, const CancelToken& cancel) {
  if (balls.centres.empty()) return {};
  return Builder(balls, molecule, shown).build(prepared.left_out, bonds, cancel);
}

}  // namespace alphascope
