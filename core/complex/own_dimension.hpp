// SPDX-License-Identifier: GPL-3.0-or-later
// The classes of a complex in its own dimension. If all centres are in a plane, on a line or at one
// point, the largest simplices are triangles, edges or vertices. Engines give the classes of space,
// where nothing in a plane is ever interior. Areas and volumes are measured in space, and engines
// are compared there. Only this file converts the classes.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "core/complex/alpha_complex.hpp"

namespace alphascope {

struct BallSet;

// Sets the classes for the dimension of all centres (dimension_of_centres()). The largest simplices
// become interior. Their faces become singular, regular or interior by the number of largest
// simplices that they belong to, 0 to 2. Smaller faces follow from their cofaces, as in space. Does
// nothing in dimension 3, or if only tetrahedra were computed.
void set_classes_in(int dimension, AlphaComplex& complex);

// A complex as it is shown: the complex itself in space, else a copy with other classes.
class InOwnDimension {
 public:
  // Both arguments must outlive this object.
  InOwnDimension(const BallSet& balls, const AlphaComplex& complex);
  // Not movable, since it may refer to its own copy.
  InOwnDimension(const InOwnDimension&) = delete;
  InOwnDimension& operator=(const InOwnDimension&) = delete;

  int dimension() const { return dimension_; }
  const AlphaComplex& complex() const { return copy_ ? *copy_ : complex_; }

 private:
  const AlphaComplex& complex_;
  int dimension_;
  std::optional<AlphaComplex> copy_;
};

// The number of simplices of each class, in an array by dimension: [0] is for vertices, [3] for
// tetrahedra.
struct ClassCounts {
  std::size_t singular = 0, regular = 0, interior = 0;
  std::size_t all() const { return singular + regular + interior; }
  friend bool operator==(const ClassCounts&, const ClassCounts&) = default;
};
std::array<ClassCounts, 4> class_counts(const AlphaComplex& complex);

}  // namespace alphascope
