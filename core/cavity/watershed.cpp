// SPDX-License-Identifier: GPL-3.0-or-later
// Assigns tetrahedra of a network to its parts: joins them through gates in the order of opening.
#include "core/cavity/watershed.hpp"

#include <tbb/parallel_sort.h>

#include <algorithm>

#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/gates.hpp"
#include "core/run/parallel.hpp"
#include "core/triangulation/incidence.hpp"
#include "core/triangulation/membership.hpp"
#include "core/triangulation/union_find.hpp"

namespace alphascope {
namespace {

constexpr std::uint32_t kNone = Cavities::kNone;

}  // namespace

std::vector<std::uint32_t> watershed(const CavityGround& ground, const Membership& in,
                                     const Cavities& found, std::uint32_t index,
                                     const NetworkParting& parting, const CancelToken& cancel) {
  const std::vector<std::uint32_t>& tetrahedra = found.cavities[index].tetrahedra;
  const auto local = [&](std::uint32_t t) {
    return static_cast<std::uint32_t>(std::lower_bound(tetrahedra.begin(), tetrahedra.end(), t) -
                                      tetrahedra.begin());
  };
  // The part of each tetrahedron, as an index of descendants. Only the entries of the roots of
  // `sets` are kept up to date.
  std::vector<std::uint32_t> part_of(tetrahedra.size(), kNone);
  for (std::uint32_t k = 0; k < parting.descendants.size(); ++k) {
    for (const std::uint32_t t : parting.there.cavities[parting.descendants[k]].tetrahedra) {
      part_of[local(t)] = k;
    }
  }
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t n = 0; n < tetrahedra.size(); ++n) {
    for (const std::uint32_t f : ground.incidence.triangles_of_tetrahedron[tetrahedra[n]]) {
      const auto [a, b] = ground.incidence.tetrahedra_of_triangle[f];
      if (a != tetrahedra[n] || b == Incidence::kOutside || in.triangles[f] ||
          found.cavity_of_tetrahedron[b] != index) {
        continue;
      }
      // Triangles between two tetrahedra of descendants are not needed, because these keep their
      // parts.
      if (part_of[n] == kNone || part_of[local(b)] == kNone) triangles.push_back(f);
    }
  }
  std::vector<Gate> gates(triangles.size());
  parallel_many(gates.size(), cancel,
                [&](std::size_t n) { gates[n] = gate_of(ground, triangles[n]); });
  tbb::parallel_sort(gates.begin(), gates.end(),
                     [&](const Gate& a, const Gate& b) { return opens_before(ground, a, b); });
  cancel.throw_if_cancelled();
  UnionFind sets(tetrahedra.size());
  for (const Gate& gate : gates) {
    const auto [a, b] = ground.incidence.tetrahedra_of_triangle[gate.triangle];
    const std::uint32_t root_a = sets.root(local(a)), root_b = sets.root(local(b));
    const std::uint32_t of_a = part_of[root_a], of_b = part_of[root_b];
    if (root_a == root_b || (of_a != kNone && of_b != kNone)) continue;
    sets.unite(root_a, root_b);
    part_of[std::min(root_a, root_b)] = of_a != kNone ? of_a : of_b;
  }
  for (std::uint32_t n = 0; n < part_of.size(); ++n) part_of[n] = part_of[sets.root(n)];
  return part_of;
}

}  // namespace alphascope
