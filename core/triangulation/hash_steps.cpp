// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the steps: quantiles of the alpha values, and the hash sums up to each.
#include "core/triangulation/hash_steps.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>
#include <tbb/task_group.h>

#include <array>

#include "core/complex/alpha_complex.hpp"
#include "core/complex/simplex_hash.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {
namespace {

// With so many steps, a threshold has to hash less than 1 % of the simplices on average.
constexpr std::size_t kSteps = 63, kSamplesPerStep = 64;
using StepSums = std::array<std::uint64_t, kSteps + 1>;  // the last one: above all steps
using StepValues = std::array<float, kSteps + 1>;

// Quantiles of a sample of the alpha values, strictly ascending.
template <int N>
std::vector<HashSteps::Step> step_edges(const SimplexList<N>& list) {
  const std::size_t stride = list.size() / (kSteps * kSamplesPerStep) + 1;
  std::vector<float> sample;
  for (std::size_t n = 0; n < list.size(); n += stride) sample.push_back(list.alpha_values[n]);
  std::sort(sample.begin(), sample.end());
  std::vector<HashSteps::Step> steps;
  for (std::size_t s = 0; s < kSteps && !sample.empty(); ++s) {
    const float edge = sample[(sample.size() - 1) * s / (kSteps - 1)];
    if (steps.empty() || steps.back().alpha_value < edge) steps.push_back({edge, 0});
  }
  return steps;
}

// The alpha values of the steps, padded with infinity for a search without branches. A processor
// would predict about half of the branches wrongly.
StepValues search_list(const std::vector<HashSteps::Step>& steps) {
  StepValues values;
  values.fill(std::numeric_limits<float>::infinity());
  for (std::size_t n = 0; n < steps.size(); ++n) values[n] = steps[n].alpha_value;
  return values;
}

// The number of steps with an alpha value below `value`.
std::size_t step_of(const StepValues& list, float value) {
  std::size_t at = 0;
  for (std::size_t half = (kSteps + 1) / 2; half > 0; half /= 2) {
    at += half * static_cast<std::size_t>(list[at + half - 1] < value);
  }
  return at;
}

}  // namespace

template <int N>
HashSteps::HashSteps(const SimplexList<N>& list, const CancelToken& cancel)
    : steps_(step_edges(list)) {
  const StepValues values = search_list(steps_);
  using Range = tbb::blocked_range<std::size_t>;
  tbb::task_group_context own(tbb::task_group_context::isolated);  // see parallel.cpp
  const StepSums sums = tbb::parallel_reduce(
      Range(0, list.size(), 4096), StepSums{},
      [&](const Range& range, StepSums sum) {
        if (cancel.cancelled()) return sum;
        for (std::size_t n = range.begin(); n != range.end(); ++n) {
          sum[step_of(values, list.alpha_values[n])] += simplex_hash<N>(list.simplices[n].data());
        }
        return sum;
      },
      [](StepSums a, const StepSums& b) {
        for (std::size_t n = 0; n < a.size(); ++n) a[n] += b[n];
        return a;
      },
      own);
  cancel.throw_if_cancelled();
  std::uint64_t sum = 0;
  for (std::size_t n = 0; n < steps_.size(); ++n) steps_[n].sum = sum += sums[n];
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
