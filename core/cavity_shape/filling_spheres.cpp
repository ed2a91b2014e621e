// SPDX-License-Identifier: GPL-3.0-or-later
// Fills a cavity with spheres around orthocentres, and thins them out if there are too many.
#include "core/cavity_shape/filling_spheres.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <unordered_set>

#include "core/cavity/cavity_ground.hpp"
#include "core/cavity_identity/point_location.hpp"
#include "core/clearance/clearance.hpp"
#include "core/clearance/orthocentre.hpp"
#include "core/neighbours/uniform_grid.hpp"
#include "core/run/parallel.hpp"

namespace alphascope {
namespace {

bool is_on_lattice(const RealPoint& p) {
  constexpr double kMost = kMaxLatticeCoordinate;
  return std::fabs(p.x) <= kMost && std::fabs(p.y) <= kMost && std::fabs(p.z) <= kMost;
}

bool holds(const Cavity& cavity, std::uint32_t tetrahedron) {
  return std::binary_search(cavity.tetrahedra.begin(), cavity.tetrahedra.end(), tetrahedron);
}

FillingSphere sphere_at(const CavityGround& ground, const Cavity& cavity,
                        const Clearance& clearance, std::uint32_t t) {
  FillingSphere sphere{{}, 0, t};
  const RealPoint centre = orthocentre(*ground.balls, ground.triangulation->tetrahedra[t]);
  if (!is_on_lattice(centre)) return sphere;
  const LatticePoint place = nearest_lattice_point(centre);
  if (!holds(cavity,
             walk_to({place.x, place.y, place.z}, *ground.balls, *ground.triangulation, t))) {
    return sphere;
  }
  sphere.centre_angstrom = ground.balls->lattice.unit_angstrom() * real_point(place);
  sphere.radius_angstrom = clearance.at(sphere.centre_angstrom);
  return sphere;
}

// A cell of spheres: their radii have the same binary exponent, and their centres are in the same
// cube. The cube's edge is `share` times that power of two (Å). Such cubes are within the bounds of
// the lattice, so their indices are exact.
struct Cell {
  std::array<std::int64_t, 4> place;
  friend bool operator==(const Cell&, const Cell&) = default;
};
struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    std::uint64_t hash = 0;
    for (const std::int64_t n : cell.place) {
      hash = (hash ^ static_cast<std::uint64_t>(n)) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 32;
    }
    return hash;
  }
};

Cell cell_of(const FillingSphere& sphere, double share) {
  const int exponent = std::ilogb(sphere.radius_angstrom);
  const double edge = std::ldexp(share, exponent);
  const auto along = [&](double x) { return static_cast<std::int64_t>(std::floor(x / edge)); };
  const RealPoint& c = sphere.centre_angstrom;
  return {{exponent, along(c.x), along(c.y), along(c.z)}};
}

// Keeps only the first sphere of each cell.
void thin_out(std::vector<FillingSphere>& spheres, double share) {
  std::unordered_set<Cell, CellHash> taken(spheres.size());
  std::erase_if(spheres, [&](const FillingSphere& sphere) {
    return !taken.insert(cell_of(sphere, share)).second;
  });
}

// Orders spheres by falling radius. Spheres at the same place are then neighbours.
bool is_before(const FillingSphere& a, const FillingSphere& b) {
  const auto key = [](const FillingSphere& s) {
    const RealPoint& c = s.centre_angstrom;
    return std::make_tuple(-s.radius_angstrom, c.x, c.y, c.z, s.tetrahedron);
  };
  return key(a) < key(b);
}
bool at_one_place(const FillingSphere& a, const FillingSphere& b) {
  return a.centre_angstrom == b.centre_angstrom;
}

}  // namespace

std::vector<FillingSphere> filling_spheres(const CavityGround& ground, const Cavity& cavity,
                                           const Clearance& clearance, std::size_t most,
                                           const CancelToken& cancel) {
  if (most == 0) return {};
  std::vector<FillingSphere> spheres(cavity.tetrahedra.size());
  parallel_many(spheres.size(), cancel, [&](std::size_t n) {
    spheres[n] = sphere_at(ground, cavity, clearance, cavity.tetrahedra[n]);
  });
  std::erase_if(spheres, [](const FillingSphere& s) { return !(s.radius_angstrom > 0); });
  std::sort(spheres.begin(), spheres.end(), is_before);
  spheres.erase(std::unique(spheres.begin(), spheres.end(), at_one_place), spheres.end());
  constexpr double kCoarsest = 2;  // cubes as large as the spheres in them
  for (double share = 0.125; spheres.size() > most && share <= kCoarsest; share *= 2) {
    cancel.throw_if_cancelled();
    thin_out(spheres, share);
  }
  if (spheres.size() > most) spheres.resize(most);
  return spheres;
}

}  // namespace alphascope
