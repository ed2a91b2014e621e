// SPDX-License-Identifier: GPL-3.0-or-later
// The signature of a molecule: numbers of simplices of each dimension, and the Euler number, as
// functions of alpha. It is made from the filtration, for all alphas at once.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/complex/simplices.hpp"
#include "core/document/store/derived.hpp"
#include "core/geometry/lattice.hpp"
#include "core/triangulation/memory_need.hpp"

namespace alphascope {

struct AlphaComplex;
struct RunContext;

struct Signature {
  Lattice lattice;
  // Alpha values of the simplices of dimension 0 to 3, ascending, in square lattice units.
  std::array<std::vector<float>, 4> values;

  // Number of simplices of one dimension with an alpha value of at most `alpha` (Å²). Alpha values
  // are rounded to floats here. So simplices within that rounding of alpha may be counted wrongly;
  // the complex itself decides them exactly.
  std::size_t count(int dimension, double alpha) const {
    const std::vector<float>& v = values[static_cast<std::size_t>(dimension)];
    const auto limit = lattice.alpha_on_lattice(alpha).nearest_float();
    return static_cast<std::size_t>(std::upper_bound(v.begin(), v.end(), limit) - v.begin());
  }
  // Vertices - edges + triangles - tetrahedra = components - tunnels + voids.
  long long euler(double alpha) const {
    long long number = 0;
    for (int d = 0; d < 4; ++d) {
      number += (d % 2 == 0 ? 1 : -1) * static_cast<long long>(count(d, alpha));
    }
    return number;
  }
  // The least alpha (Å²) with a nonempty complex; 0 without balls.
  double least_alpha() const {
    return values[0].empty() ? 0 : lattice.square_angstrom(values[0].front());
  }
};

inline Signature make_signature(const Filtration& filtration, const RunContext& context = {}) {
  const AlphaComplex& all = filtration.top();
  Signature signature;
  signature.lattice = all.lattice;
  const auto take = [&](std::size_t dimension, const ResultArray<float>& from) {
    context.report("signature", static_cast<double>(dimension) / 4);
    context.cancel.throw_if_cancelled();
    std::vector<float>& to = signature.values[dimension];
    to.assign(from.begin(), from.end());
    std::sort(to.begin(), to.end());
  };
  take(0, all.vertices.alpha_values);
  take(1, all.edges.alpha_values);
  take(2, all.triangles.alpha_values);
  take(3, all.tetrahedra.alpha_values);
  return signature;
}

inline const Definition<Signature>& whole_signature() {
  static const Definition<Signature> definition{
      {.id = "signature",
       .title = "Signature",
       .made_of = {&whole_filtration()},
       .key = key_of_balls,
       .memory =
           [](const Inputs& in) {
             const AlphaComplex& all = in.of(whole_filtration()).top();
             const std::uint64_t bytes =
                 sizeof(float) * (all.vertices.size() + all.edges.size() + all.triangles.size() +
                                  all.tetrahedra.size());
             return MemoryNeed{bytes, bytes};
           }},
      [](const Inputs& in, const RunContext& context) {
        return std::make_shared<const Signature>(
            make_signature(in.of(whole_filtration()), context));
      }};
  return definition;
}

}  // namespace alphascope
