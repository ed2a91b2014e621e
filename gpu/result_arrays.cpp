#include "gpu/result_arrays.hpp"

#include <tbb/parallel_invoke.h>

namespace alphascope::gpu {
namespace {

template <int N>
void copy(const HostSimplices<N>& from, SimplexList<N>& to) {
  to.simplices.assign(from.simplices.begin(), from.simplices.end());
  to.alpha_values.assign(from.values.begin(), from.values.end());
  if (N == 4) {  // no coface: all of K_alpha's are interior
    to.classes.assign(from.values.size(), SimplexClass::interior);
  } else {
    to.classes.assign(from.classes.begin(), from.classes.end());
  }
}

}  // namespace

void copy_result(const PipelineResult& from, AlphaComplex& to) {
  tbb::parallel_invoke(
      [&] { copy(from.vertices, to.vertices); }, [&] { copy(from.edges, to.edges); },
      [&] { copy(from.triangles, to.triangles); }, [&] { copy(from.tetrahedra, to.tetrahedra); });
}

}  // namespace alphascope::gpu
