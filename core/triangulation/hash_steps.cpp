// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the steps: quantiles of the alpha values, and the hash sums up to each.
#include "core/triangulation/hash_steps.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>
#include <tbb/task_group.h>

#include <utility>

#include "core/complex/alpha_complex.hpp"
#include "core/complex/simplex_hash.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {
namespace {

template <int N>
StepValues step_values_of(const SimplexList<N>& list) {
  const std::size_t stride = sample_stride(list.size());
  std::vector<float> sample;
  for (std::size_t n = 0; n < list.size(); n += stride) sample.push_back(list.alpha_values[n]);
  return step_values(std::move(sample));
}

template <int N>
StepSums step_sums(const SimplexList<N>& list, const StepValues& values,
                   const CancelToken& cancel) {
  using Range = tbb::blocked_range<std::size_t>;
  tbb::task_group_context own(tbb::task_group_context::isolated);  // see parallel.cpp
  const StepSums sums = tbb::parallel_reduce(
      Range(0, list.size(), 4096), StepSums{},
      [&](const Range& range, StepSums sum) {
        if (cancel.cancelled()) return sum;
        for (std::size_t n = range.begin(); n != range.end(); ++n) {
          sum[static_cast<std::size_t>(values.step_of(list.alpha_values[n]))] +=
              simplex_hash<N>(list.simplices[n].data());
        }
        return sum;
      },
      [](StepSums a, const StepSums& b) {
        for (std::size_t n = 0; n < a.size(); ++n) a[n] += b[n];
        return a;
      },
      own);
  cancel.throw_if_cancelled();
  return sums;
}

}  // namespace

template <int N>
HashSteps::HashSteps(const SimplexList<N>& list, const CancelToken& cancel) {
  if (list.size() == 0) return;
  const StepValues values = step_values_of(list);
  *this = HashSteps(values, step_sums(list, values, cancel));
}

HashStepsByDimension::HashStepsByDimension(const AlphaComplex& top, const CancelToken& cancel)
    : vertices(top.vertices, cancel),
      edges(top.edges, cancel),
      triangles(top.triangles, cancel),
      tetrahedra(top.tetrahedra, cancel) {}

template HashSteps::HashSteps(const SimplexList<1>&, const CancelToken&);
template HashSteps::HashSteps(const SimplexList<2>&, const CancelToken&);
template HashSteps::HashSteps(const SimplexList<3>&, const CancelToken&);
template HashSteps::HashSteps(const SimplexList<4>&, const CancelToken&);

}  // namespace alphascope
