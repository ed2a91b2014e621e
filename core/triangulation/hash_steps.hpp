// Hash sums of all simplices of one dimension up to some alpha values, the steps: what a threshold
// then has to hash lies between two of them. Hashing was two thirds of a threshold's time.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/complex/alpha_complex.hpp"
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
  HashSteps(const SimplexList<N>& list, const CancelToken& cancel);

  // The last step whose alpha value is not above the bound; one below all values if there is none.
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
  HashStepsByDimension(const AlphaComplex& top, const CancelToken& cancel)
      : vertices(top.vertices, cancel),
        edges(top.edges, cancel),
        triangles(top.triangles, cancel),
        tetrahedra(top.tetrahedra, cancel) {}
};

}  // namespace alphascope
