// Hash sums of all simplices of one dimension up to some alpha values, the steps: what a threshold
// then has to hash lies between two of them. Hashing was two thirds of a threshold's time.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/complex/alpha_complex.hpp"
#include "core/complex/simplex_hash.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

class HashSteps {
 public:
  // The sum of simplex_hash() over all simplices of alpha values up to and including this one.
  struct Step {
    float alpha_value;
    std::uint64_t sum;
  };

  HashSteps() = default;
  // Works in the caller's task arena. Throws Cancelled.
  template <int N>
  HashSteps(const SimplexList<N>& list, const CancelToken& cancel) : steps_(edges(list)) {
    const auto values = search_list();
    const Sums sums = tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, list.size(), 4096), Sums{},
        [&](const tbb::blocked_range<std::size_t>& range, Sums sum) {
          if (cancel.cancelled()) return sum;
          for (std::size_t n = range.begin(); n != range.end(); ++n) {
            sum[step_of(values, list.alpha_values[n])] += simplex_hash<N>(list.simplices[n].data());
          }
          return sum;
        },
        [](Sums a, const Sums& b) {
          for (std::size_t n = 0; n < a.size(); ++n) a[n] += b[n];
          return a;
        });
    cancel.throw_if_cancelled();
    std::uint64_t sum = 0;
    for (std::size_t n = 0; n < steps_.size(); ++n) steps_[n].sum = sum += sums[n];
  }

  // The last step whose alpha value is not above the bound; one below all values if there is none.
  Step last_within(float bound) const {
    const auto after =
        std::upper_bound(steps_.begin(), steps_.end(), bound,
                         [](float value, const Step& step) { return value < step.alpha_value; });
    if (after == steps_.begin()) return {-std::numeric_limits<float>::infinity(), 0};
    return *(after - 1);
  }

 private:
  // Half of 1/64 of the simplices is left to be hashed, on average.
  static constexpr std::size_t kSteps = 63, kSamplesPerStep = 64;
  using Sums = std::array<std::uint64_t, kSteps + 1>;  // the last: above all steps

  // Quantiles of a sample of the alpha values, which ascend strictly.
  template <int N>
  static std::vector<Step> edges(const SimplexList<N>& list) {
    const std::size_t stride = list.size() / (kSteps * kSamplesPerStep) + 1;
    std::vector<float> sample;
    for (std::size_t n = 0; n < list.size(); n += stride) sample.push_back(list.alpha_values[n]);
    std::sort(sample.begin(), sample.end());
    std::vector<Step> steps;
    for (std::size_t s = 0; s < kSteps && !sample.empty(); ++s) {
      const float edge = sample[(sample.size() - 1) * s / (kSteps - 1)];
      if (steps.empty() || steps.back().alpha_value < edge) steps.push_back({edge, 0});
    }
    return steps;
  }

  // The steps' alpha values, for a search without branches, which would be guessed wrong half of
  // the time.
  std::array<float, kSteps + 1> search_list() const {
    std::array<float, kSteps + 1> values;
    values.fill(std::numeric_limits<float>::infinity());
    for (std::size_t n = 0; n < steps_.size(); ++n) values[n] = steps_[n].alpha_value;
    return values;
  }
  // How many of them are below the value.
  static std::size_t step_of(const std::array<float, kSteps + 1>& list, float value) {
    std::size_t at = 0;
    for (std::size_t half = (kSteps + 1) / 2; half > 0; half /= 2) {
      at += half * static_cast<std::size_t>(list[at + half - 1] < value);
    }
    return at;
  }

  std::vector<Step> steps_;
};

struct HashStepsByDimension {
  HashSteps vertices, edges, triangles, tetrahedra;

  HashStepsByDimension() = default;
  HashStepsByDimension(const AlphaComplex& top, const CancelToken& cancel)
      : vertices(top.vertices, cancel),
        edges(top.edges, cancel),
        triangles(top.triangles, cancel),
        tetrahedra(top.tetrahedra, cancel) {}
};

}  // namespace alphascope
