// SPDX-License-Identifier: GPL-3.0-or-later
// Measures cavities by clipping each of their tetrahedra against the balls.
#include <tbb/task_arena.h>

#include <algorithm>

#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/cavity_measures.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/measure/exact_outside.hpp"
#include "core/measure/exact_sum.hpp"

namespace alphascope {
namespace {

// Sums values from `first` to before `end`. Sorts them by size first, so that the order of the
// tetrahedra changes no bit.
double sum_of(std::vector<double>& values, std::size_t first, std::size_t end) {
  std::sort(values.begin() + static_cast<std::ptrdiff_t>(first),
            values.begin() + static_cast<std::ptrdiff_t>(end));
  NeumaierSum sum;
  for (std::size_t n = first; n < end; ++n) sum.add(values[n]);
  return sum.value();
}

}  // namespace

std::vector<ExactCavityMeasures> measure_cavities_exactly(const CavityGround& ground,
                                                          const Cavities& cavities,
                                                          std::span<const std::uint32_t> which,
                                                          const LatticeAlpha& alpha_on_lattice,
                                                          const RunContext& context) {
  std::vector<std::uint32_t> tetrahedra;
  for (const std::uint32_t c : which) {
    const auto& of = cavities.cavities.at(c).tetrahedra;
    tetrahedra.insert(tetrahedra.end(), of.begin(), of.end());
  }
  if (tetrahedra.empty()) return {};
  ExactTetrahedra parts =
      exact_outside(*ground.triangulation, *ground.balls, alpha_on_lattice, tetrahedra,
                    tbb::this_task_arena::max_concurrency(), context);
  std::vector<ExactCavityMeasures> measures;
  std::size_t n = 0;
  for (const std::uint32_t c : which) {
    const std::size_t end = n + cavities.cavities[c].tetrahedra.size();
    measures.push_back(
        {sum_of(parts.free_volume_angstrom3, n, end), sum_of(parts.area_angstrom2, n, end)});
    n = end;
  }
  return measures;
}

}  // namespace alphascope
