// SPDX-License-Identifier: GPL-3.0-or-later
// Finds bonds by distance: E. C. Meng and R. A. Lewis, "Determination of molecular topology and
// atomic hybridization states from heavy atom coordinates", Journal of Computational Chemistry 12,
// 1991. Two atoms are bonded if their distance is at most the sum of their covalent radii plus 0.4
// Å. The radii are those of B. Cordero et al., "Covalent radii revisited", Dalton Transactions,
// 2008. The bonds are only drawn; no result depends on them.
#include "ui/scene/mesh/beside_body.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/geometry/alpha.hpp"
#include "core/molecule/atom_colours.hpp"

namespace alphascope {
namespace {

constexpr double kTolerance = 0.4, kLeastBond = 0.4;  // Å
constexpr double kLongestBond = 4;                    // Å; atoms farther apart are not tested
// Å, as drawn. Balls of the body are drawn with 0.3 of their radius, about 0.5 Å.
constexpr float kBall = 0.34f, kHydrogenBall = 0.2f, kWaterBall = 0.42f, kIonBall = 0.8f;
constexpr double kStick = 0.13;  // Å
// Most sticks that are drawn. With more, no single bond could be seen, and they would take hundreds
// of megabytes.
constexpr std::size_t kMostSticks = 30000;

// Covalent radius, Å.
double covalent_radius(Element element) {
  constexpr std::array<double, 38> kRadii{
      0,    0.31, 0.28, 1.28, 0.96, 0.84, 0.76, 0.71, 0.66, 0.57, 0.58, 1.66, 1.41,
      1.21, 1.11, 1.07, 1.05, 1.02, 1.06, 2.03, 1.76, 1.70, 1.60, 1.53, 1.39, 1.39,
      1.32, 1.26, 1.24, 1.32, 1.22, 1.22, 1.20, 1.19, 1.20, 1.20, 1.16, 2.20};
  constexpr double kIodine = 1.39, kOthers = 1.45;
  if (element == 53) return kIodine;
  return element > 0 && element < kRadii.size() ? kRadii[element] : kOthers;
}

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

  BesideBody build(const std::vector<LeftOutAtom>& left_out, const CancelToken& cancel) {
    for (const LeftOutAtom& a : left_out) {
      const Element element = molecule_.atoms[a.atom].element;
      if (!shows(shown_, a.reason, element)) continue;
      atoms_.push_back(a);
      const RealPoint p = place(a.atom);
      spheres_.centres.push_back(
          {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
      spheres_.radii.push_back(drawn_radius(a.reason, element));
      mesh_.opaque.sphere_colours.push_back(element_colour(element));
      if (a.reason == DropReason::ligand) ligands_.push_back(a.atom);
      if (element == kHydrogen && a.reason != DropReason::ligand) find_parent(a.atom);
    }
    if (atoms_.empty()) return {};
    cancel.throw_if_cancelled();
    find_bonds();
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

  bool bonded(std::uint32_t a, std::uint32_t b) const {
    const Element e = molecule_.atoms[a].element, f = molecule_.atoms[b].element;
    if (e == kHydrogen && f == kHydrogen) return false;
    const double distance = length(place(a) - place(b));
    return distance >= kLeastBond &&
           distance <= covalent_radius(e) + covalent_radius(f) + kTolerance;
  }

  // The parent of a hydrogen is the nearest bonded heavy atom of its residue, in the body or beside
  // it.
  void find_parent(std::uint32_t hydrogen) {
    const auto& atoms = molecule_.atoms;
    std::uint32_t parent = hydrogen;
    double nearest = kLongestBond;
    const auto consider = [&](std::uint32_t i) {
      if (!same_residue_number(atoms[i], atoms[hydrogen])) return false;
      const double distance = length(place(i) - place(hydrogen));
      if (atoms[i].element != kHydrogen && distance < nearest && bonded(i, hydrogen)) {
        nearest = distance;
        parent = i;
      }
      return true;
    };
    for (std::uint32_t i = hydrogen; i > 0 && consider(i - 1); --i) continue;
    for (std::uint32_t i = hydrogen + 1; i < atoms.size() && consider(i); ++i) continue;
    if (parent != hydrogen) bonds_.push_back({parent, hydrogen});
  }

  // Finds bonds between atoms of ligands, also across residues, as in sugars. Atoms are sorted by
  // x, so that only pairs near in x are tested.
  void find_bonds() {
    const auto x = [this](std::uint32_t atom) { return molecule_.atoms[atom].position.x; };
    std::sort(ligands_.begin(), ligands_.end(),
              [&](std::uint32_t a, std::uint32_t b) { return x(a) < x(b); });
    const double reach = kLongestBond / molecule_.lattice.unit_angstrom();
    for (std::size_t i = 0; i < ligands_.size(); ++i) {
      for (std::size_t k = i + 1; k < ligands_.size() && x(ligands_[k]) - x(ligands_[i]) <= reach;
           ++k) {
        if (bonded(ligands_[i], ligands_[k])) bonds_.push_back({ligands_[i], ligands_[k]});
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
  std::vector<std::uint32_t> ligands_;
  std::vector<std::array<std::uint32_t, 2>> bonds_;
};

}  // namespace

BesideBody build_beside_body(const BallGeometry& balls, const Molecule& molecule,
                             const PreparedBalls& prepared, const AtomsBesideBody& shown,
                             const CancelToken& cancel) {
  if (balls.centres.empty()) return {};
  return Builder(balls, molecule, shown).build(prepared.left_out, cancel);
}

}  // namespace alphascope
