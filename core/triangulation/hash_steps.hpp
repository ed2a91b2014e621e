// SPDX-License-Identifier: GPL-3.0-or-later
// Hash sums of all simplices of one dimension up to some alpha values, the steps. A threshold then
// hashes only the simplices between the last step and alpha. If it hashed all, this would take two
// thirds of its time.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace alphascope {

template <int N>
struct SimplexList;
class CancelToken;
struct AlphaComplex;

class HashSteps {
 public:
  // The sum of simplex_hash() over all simplices with alpha values up to and including this one.
  struct Step {
    float alpha_value;
    std::uint64_t sum;
  };

  HashSteps() = default;
  // Works in the caller's task arena. Throws Cancelled.
  template <int N>
  HashSteps(const SimplexList<N>& list, const CancelToken& cancel);

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
};

}  // namespace alphascope
