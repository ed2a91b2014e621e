#include "core/complex/alpha_complex.hpp"

#include <cstdio>

namespace alphascope {
namespace {

// Finaliser of splitmix64 (Steele, Lea, Flood, OOPSLA 2014): a bijection that mixes all bits.
std::uint64_t mix(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

// A sum does not depend on the order of its terms.
template <int N>
std::uint64_t set_hash(const SimplexList<N>& list) {
  std::uint64_t sum = 0;
  for (const auto& simplex : list.simplices) {
    std::uint64_t h = N;
    for (const BallIndex v : simplex) h = mix(h ^ v);
    sum += h;
  }
  return mix(sum ^ list.size());
}

}  // namespace

std::uint64_t tetrahedra_hash(const AlphaComplex& complex) {
  return set_hash(complex.tetrahedra);
}

std::uint64_t complex_hash(const AlphaComplex& complex) {
  std::uint64_t h = tetrahedra_hash(complex);
  if (complex.tetrahedra_only) return h;
  h = mix(h ^ set_hash(complex.triangles));
  h = mix(h ^ set_hash(complex.edges));
  return mix(h ^ set_hash(complex.vertices));
}

std::string hash_text(std::uint64_t hash) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

}  // namespace alphascope
