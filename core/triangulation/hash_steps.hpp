// SPDX-License-Identifier: GPL-3.0-or-later
// Hash sums of all simplices of one dimension up to some alpha values, the steps. A threshold then
// hashes only the simplices between the last step and alpha. If it hashed all, this would take two
// thirds of its time.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <vector>

#include "core/geometry/host_device.hpp"

namespace alphascope {

template <int N>
struct SimplexList;
class CancelToken;
struct AlphaComplex;

// Alpha values between which simplices are counted as one step, strictly ascending and padded with
// infinity. With so many, a threshold has to hash less than 1 % of the simplices on average. Host
// and device.
struct StepValues {
  static constexpr int kMost = 63;
  float value[kMost + 1];

  // The number of these values that are below `of`. Without branches, because a processor would
  // predict about half of them wrongly.
  ALPHASCOPE_HOST_DEVICE int step_of(float of) const {
    int at = 0;
    for (int half = (kMost + 1) / 2; half > 0; half /= 2) {
      at += half * static_cast<int>(value[at + half - 1] < of);
    }
    return at;
  }
};
// For each step, the sum of simplex_hash() over its simplices; last, those above all values.
using StepSums = std::array<std::uint64_t, StepValues::kMost + 1>;

// These are in the header for the reason that core/complex/simplex_count.hpp gives.
// Every how many simplices of a list of this size one goes into the sample.
inline std::size_t sample_stride(std::size_t simplices) {
  constexpr std::size_t kSamplesPerStep = 64;
  return simplices / (StepValues::kMost * kSamplesPerStep) + 1;
}
// Quantiles of a sample of the alpha values: those of simplices 0, stride, 2 stride, and so on.
inline StepValues step_values(std::vector<float> sample) {
  constexpr std::size_t kSteps = StepValues::kMost;
  std::sort(sample.begin(), sample.end());
  StepValues values;
  std::fill(std::begin(values.value), std::end(values.value),
            std::numeric_limits<float>::infinity());
  std::size_t steps = 0;
  for (std::size_t s = 0; s < kSteps && !sample.empty(); ++s) {
    const float edge = sample[(sample.size() - 1) * s / (kSteps - 1)];
    if (steps == 0 || values.value[steps - 1] < edge) values.value[steps++] = edge;
  }
  return values;
}

class HashSteps {
 public:
  // The sum of simplex_hash() over all simplices with alpha values up to and including this one.
  struct Step {
    float alpha_value;
    std::uint64_t sum;
    friend bool operator==(const Step&, const Step&) = default;
  };

  HashSteps() = default;
  HashSteps(const StepValues& values, const StepSums& sums) {
    std::uint64_t sum = 0;
    for (std::size_t n = 0; n < StepValues::kMost; ++n) {
      const float value = values.value[n];
      if (n > 0 && !(steps_.back().alpha_value < value)) break;  // the padding
      steps_.push_back({value, sum += sums[n]});
    }
  }
  // Works in the caller's task arena. Throws Cancelled.
  template <int N>
  HashSteps(const SimplexList<N>& list, const CancelToken& cancel);

  friend bool operator==(const HashSteps&, const HashSteps&) = default;

  // The last step whose alpha value is not above the bound. Without such a step: one with the value
  // minus infinity and the sum 0.
  Step last_within(float bound) const {
    const auto after =
        std::upper_bound(steps_.begin(), steps_.end(), bound,
                         [](float value, const Step& step) { return value < step.alpha_value; });
    if (after == steps_.begin()) return {-std::numeric_limits<float>::infinity(), 0};
    return *(after - 1);
  }

 private:
  std::vector<Step> steps_;
};

struct HashStepsByDimension {
  HashSteps vertices, edges, triangles, tetrahedra;

  HashStepsByDimension() = default;
  HashStepsByDimension(const AlphaComplex& top, const CancelToken& cancel);
  friend bool operator==(const HashStepsByDimension&, const HashStepsByDimension&) = default;
};

}  // namespace alphascope
