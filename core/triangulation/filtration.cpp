// SPDX-License-Identifier: GPL-3.0-or-later
// The complex at one alpha as a threshold of a filtration. The float of an alpha value decides,
// except where alpha itself rounds to the same float. Those simplices are the ties, and they are
// decided exactly.
#include "core/triangulation/filtration.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "core/complex/alpha_complex.hpp"
#include "core/complex/face_class.hpp"
#include "core/complex/face_groups.hpp"
#include "core/complex/simplex_hash.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/run/parallel.hpp"
#include "core/triangulation/ties.hpp"

namespace alphascope {
namespace {

// For ties of which some are in K_alpha and some are not: copies simplex by simplex, without
// classes.
template <int N>
void select_one_by_one(const SimplexList<N>& from, float limit, const Ties<N>& ties,
                       SimplexList<N>& to) {
  std::size_t tie = 0;
  for (std::size_t n = 0; n < from.size(); ++n) {
    const float value = from.alpha_values[n];
    if (value < limit || (value == limit && ties.in_complex[tie++])) {
      to.simplices.push_back(from.simplices[n]);
      to.alpha_values.push_back(value);
    }
  }
}

void select_one_by_one(const AlphaComplex& top, float limit, const AllTies& ties,
                       AlphaComplex& complex) {
  select_one_by_one(top.tetrahedra, limit, ties.tetrahedra, complex.tetrahedra);
  if (!complex.tetrahedra_only) {
    select_one_by_one(top.triangles, limit, ties.triangles, complex.triangles);
    select_one_by_one(top.edges, limit, ties.edges, complex.edges);
    select_one_by_one(top.vertices, limit, ties.vertices, complex.vertices);
    classify(complex);
  } else {
    complex.tetrahedra.alpha_values.clear();
  }
  complex.hash = complex_hash(complex);
}

// The bound for a case in which all ties are in K_alpha, or none is: a simplex with value <= bound
// is in K_alpha. A level that is never reached is NaN, so the comparison is false.
float bound_of(float limit, bool ties_in) {
  return ties_in ? limit : std::nextafter(limit, -std::numeric_limits<float>::infinity());
}

FaceLevels levels_of(const ClassLevels& levels, std::size_t n) {
  return {levels.regular_from[n], levels.interior_from[n]};
}

// Copies the simplices of one dimension with alpha values up to a bound, by all threads.
template <int N>
class Selection {
 public:
  // `levels` is null for tetrahedra, which are always interior.
  Selection(const SimplexList<N>& from, const ClassLevels* levels, const HashSteps& steps,
            float bound)
      : from_(from), levels_(levels), hashed_(steps.last_within(bound)), bound_(bound) {}

  // Fills `to`, with values and classes if requested. Returns the sum of its hash terms.
  std::uint64_t copy_to(SimplexList<N>& to, bool with_values) const {
    const std::vector<std::size_t> place = places();
    to.simplices.resize(place.back());
    to.alpha_values.resize(with_values ? place.back() : 0);
    to.classes.resize(with_values ? place.back() : 0);
    const std::uint64_t rest =
        parallel_sum(0, place.size() - 1, 1, [&](std::size_t first, std::size_t end) {
          std::uint64_t sum = 0;
          for (std::size_t b = first; b != end; ++b) {
            sum += copy_block(b, place[b], place[b + 1], with_values, to);
          }
          return sum;
        });
    return hashed_.sum + rest;
  }

 private:
  static constexpr std::size_t kBlock = 4096;

  // For each block, the index in the result of its first simplex within the bound; last, the size
  // of the result.
  std::vector<std::size_t> places() const {
    const std::size_t size = from_.size(), blocks = (size + kBlock - 1) / kBlock;
    std::vector<std::size_t> place(blocks + 1, 0);
    parallel_ranges(0, blocks, 8, [&](std::size_t first, std::size_t end) {
      for (std::size_t b = first; b != end; ++b) {
        const float* value = from_.alpha_values.data();
        unsigned count = 0;
        for (std::size_t n = b * kBlock; n < std::min(size, (b + 1) * kBlock); ++n) {
          count += value[n] <= bound_;
        }
        place[b + 1] = count;
      }
    });
    std::partial_sum(place.begin(), place.end(), place.begin());
    return place;
  }

  std::uint64_t copy_block(std::size_t block, std::size_t begin, std::size_t end, bool with_values,
                           SimplexList<N>& to) const {
    // Every simplex is written, and the next one overwrites it if it is above the bound. Writing
    // stops at `end`, where the part of the next block begins. The loop has no branch, because a
    // processor would predict about half of the branches wrongly.
    std::uint32_t to_hash[kBlock];
    std::size_t at = begin, count = 0;
    for (std::size_t n = block * kBlock; at < end; ++n) {
      const float value = from_.alpha_values[n];
      to.simplices[at] = from_.simplices[n];
      if (with_values) {
        to.alpha_values[at] = value;
        to.classes[at] =
            levels_ == nullptr ? SimplexClass::interior : class_at(levels_of(*levels_, n), bound_);
      }
      const std::size_t passes = value <= bound_;
      to_hash[count] = static_cast<std::uint32_t>(at);
      count += passes & static_cast<std::size_t>(value > hashed_.alpha_value);
      at += passes;
    }
    std::uint64_t sum = 0;
    for (std::size_t h = 0; h < count; ++h) {
      sum += simplex_hash<N>(to.simplices[to_hash[h]].data());
    }
    return sum;
  }

  const SimplexList<N>& from_;
  const ClassLevels* const levels_;
  const HashSteps::Step hashed_;  // the sum of the hash terms up to this value
  const float bound_;
};

void select(const Filtration& filtration, float bound, AlphaComplex& complex) {
  const AlphaComplex& top = filtration.top();
  const ClassLevelsByDimension& levels = filtration.levels();
  const HashStepsByDimension& steps = filtration.hash_steps();
  HashSums sums;
  const auto copy = [&](const auto& from, const ClassLevels* from_levels, const HashSteps& hashes,
                        auto& to, int dimension) {
    sums.sum[dimension] =
        Selection(from, from_levels, hashes, bound).copy_to(to, !complex.tetrahedra_only);
    sums.count[dimension] = to.size();
  };
  copy(top.tetrahedra, nullptr, steps.tetrahedra, complex.tetrahedra, 3);
  if (!complex.tetrahedra_only) {
    copy(top.triangles, &levels.triangles, steps.triangles, complex.triangles, 2);
    copy(top.edges, &levels.edges, steps.edges, complex.edges, 1);
    copy(top.vertices, &levels.vertices, steps.vertices, complex.vertices, 0);
  }
  complex.hash = sums.combined(complex.tetrahedra_only);
}

}  // namespace

AlphaComplex threshold(const Filtration& filtration, const LatticeAlpha& alpha,
                       bool tetrahedra_only) {
  const AlphaComplex& top = filtration.top();
  if (!(alpha <= filtration.alpha_max_on_lattice())) {
    throw std::invalid_argument("alpha is larger than the filtration's alpha_max");
  }
  AlphaComplex complex;
  complex.lattice = top.lattice;
  complex.alpha_on_lattice = alpha;
  complex.tetrahedra_only = tetrahedra_only;
  complex.engine.of_whole = top.engine.of_whole;
  complex.engine.rests_on_cgal = top.engine.rests_on_cgal;
  if (alpha == filtration.alpha_max_on_lattice()) {  // all simplices, without a look at ties
    select(filtration, std::numeric_limits<float>::infinity(), complex);
    return complex;
  }
  const float limit = alpha.nearest_float();
  const AllTies ties = decide_ties(filtration, alpha, tetrahedra_only);
  if (ties.any(true) && ties.any(false)) {
    select_one_by_one(top, limit, ties, complex);
  } else {
    select(filtration, bound_of(limit, ties.any(true)), complex);
  }
  return complex;
}

}  // namespace alphascope
