// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the signature from the filtration, and counts in it.
#include "core/document/alpha/signature.hpp"

#include <algorithm>
#include <cstdint>
#include <memory>

#include "core/complex/alpha_complex.hpp"
#include "core/document/store/definition.hpp"
#include "core/document/store/derived.hpp"
#include "core/document/store/inputs.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/triangulation/filtration.hpp"
#include "core/triangulation/memory_need.hpp"

namespace alphascope {

std::size_t Signature::count(int dimension, double alpha) const {
  const std::vector<float>& v = values[static_cast<std::size_t>(dimension)];
  const auto limit = lattice.alpha_on_lattice(alpha).nearest_float();
  return static_cast<std::size_t>(std::upper_bound(v.begin(), v.end(), limit) - v.begin());
}

long long Signature::euler(double alpha) const {
  long long number = 0;
  for (int d = 0; d < 4; ++d) {
    number += (d % 2 == 0 ? 1 : -1) * static_cast<long long>(count(d, alpha));
  }
  return number;
}

double Signature::least_alpha() const {
  return values[0].empty() ? 0 : lattice.square_angstrom(values[0].front());
}

Signature make_signature(const Filtration& filtration, const RunContext& context) {
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

const Definition<Signature>& whole_signature() {
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
