#include <tbb/task_arena.h>

#include "core/cavity/cavity_measures.hpp"
#include "core/measure/clipped.hpp"
#include "core/measure/exact_sum.hpp"

namespace alphascope {

std::vector<ClippedMeasures> clip_cavities(const CavityGround& ground, const Cavities& cavities,
                                           std::span<const std::uint32_t> which,
                                           const LatticeAlpha& alpha_on_lattice,
                                           const RunContext& context) {
  std::vector<std::uint32_t> tetrahedra;
  for (const std::uint32_t c : which) {
    const auto& of = cavities.cavities.at(c).tetrahedra;
    tetrahedra.insert(tetrahedra.end(), of.begin(), of.end());
  }
  if (tetrahedra.empty()) return {};
  const ClippedTetrahedra parts =
      clipped_outside(*ground.triangulation, *ground.balls, alpha_on_lattice, tetrahedra,
                      tbb::this_task_arena::max_concurrency(), context);
  std::vector<ClippedMeasures> measures;
  std::size_t n = 0;
  for (const std::uint32_t c : which) {
    NeumaierSum volume, area;
    for (const std::size_t end = n + cavities.cavities[c].tetrahedra.size(); n < end; ++n) {
      volume.add(parts.free_volume_angstrom3[n]);
      area.add(parts.area_angstrom2[n]);
    }
    measures.push_back({volume.value(), area.value()});
  }
  return measures;
}

}  // namespace alphascope
