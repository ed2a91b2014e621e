// Where all centres lie in a plane, on a line or at one point, the largest simplices are triangles,
// edges or vertices. This is the only place that gives a complex the classes of its own dimension.
// Engines give those of space, where nothing of a plane is ever interior: areas and volumes are
// measured in space, and engines are compared there.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "core/complex/alpha_complex.hpp"

namespace alphascope {

// `dimension`: of all centres (dimension_of_centres()). The largest simplices become interior; a
// face of theirs singular, regular or interior by how many of them it has, 0 to 2; a smaller one by
// its cofaces, as in space. Does nothing in dimension 3, or where only tetrahedra were computed.
void set_classes_in(int dimension, AlphaComplex& complex);

// A complex as it is shown: itself in space, else a copy with other classes.
class InOwnDimension {
 public:
  // Both must outlive this.
  InOwnDimension(const BallSet& balls, const AlphaComplex& complex);
  // Not to be moved: it may show its own copy.
  InOwnDimension(const InOwnDimension&) = delete;
  InOwnDimension& operator=(const InOwnDimension&) = delete;

  int dimension() const { return dimension_; }
  const AlphaComplex& complex() const { return copy_ ? *copy_ : complex_; }

 private:
  const AlphaComplex& complex_;
  int dimension_;
  std::optional<AlphaComplex> copy_;
};

// How many simplices of each class; [0] of vertices, [3] of tetrahedra.
struct ClassCounts {
  std::size_t singular = 0, regular = 0, interior = 0;
  std::size_t all() const { return singular + regular + interior; }
  friend bool operator==(const ClassCounts&, const ClassCounts&) = default;
};
std::array<ClassCounts, 4> class_counts(const AlphaComplex& complex);

}  // namespace alphascope
