// SPDX-License-Identifier: GPL-3.0-or-later
// The immutable result of every engine: the simplices of K_alpha with their alpha values and
// classes.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/complex/engine_info.hpp"
#include "core/complex/face_class.hpp"
#include "core/complex/shared_faces.hpp"
#include "core/complex/simplices.hpp"
#include "core/geometry/lattice.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/run/stage_timer.hpp"

namespace alphascope {

// Simplices of one dimension (N = number of vertices), in lexicographic order of their vertices;
// the vertices of each simplex ascend. The three arrays have equal length.
template <int N>
struct SimplexList {
  Simplices<N> simplices;
  // The exact alpha value rounded to the nearest float, in square lattice units. Rounding is
  // monotone, so a face never has a larger value than its coface.
  ResultArray<float> alpha_values;
  ResultArray<SimplexClass> classes;

  std::size_t size() const { return simplices.size(); }
};

struct AlphaComplex {
  Lattice lattice;
  LatticeAlpha alpha_on_lattice;  // square lattice units: the exact threshold used
  // If set, vertices, edges and triangles are empty, and tetrahedra have no alpha values or
  // classes.
  bool tetrahedra_only = false;
  SimplexList<1> vertices;
  SimplexList<2> edges;
  SimplexList<3> triangles;
  SimplexList<4> tetrahedra;
  // The faces that belong to one tetrahedron only, where a device has found them. They are those of
  // outer_faces() (core/triangulation/outer_faces.hpp).
  std::optional<SharedFaces> outside;
  std::uint64_t hash = 0;  // see complex_hash()
  EngineInfo engine;
  StageTimes timings;

  Alpha alpha_angstrom2() const { return lattice.alpha_angstrom2(alpha_on_lattice); }
  // V - E + F - T. It has a meaning only if not tetrahedra_only.
  long long euler_characteristic() const {
    return static_cast<long long>(vertices.size()) - static_cast<long long>(edges.size()) +
           static_cast<long long>(triangles.size()) - static_cast<long long>(tetrahedra.size());
  }
};

// Bytes that the arrays hold.
std::uint64_t bytes_of(const AlphaComplex& complex);

// 64-bit hash of the set of simplices: of dimension and vertex indices, but not of alpha values or
// order. Equal sets have equal hashes on every engine. A complex with tetrahedra only has another
// hash than the whole complex; tetrahedra_hash() is equal for both.
std::uint64_t complex_hash(const AlphaComplex& complex);
std::uint64_t tetrahedra_hash(const AlphaComplex& complex);

// The hash as 16 hexadecimal digits, the form in which it is shown.
std::string hash_text(std::uint64_t hash);

}  // namespace alphascope
