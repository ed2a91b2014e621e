// SPDX-License-Identifier: GPL-3.0-or-later
// Is a ball in conflict with a tetrahedron? In integers. Host and device.
#pragma once

#include "core/predicates/orthocentre_cut.hpp"
#include "core/predicates/wide_int.hpp"

namespace alphascope {

// A ball on the lattice. Of equal balls with the same centre, the one with the lowest index goes
// first.
struct IndexedBall {
  std::int32_t x, y, z, radius;
  std::uint32_t index;
};
ALPHASCOPE_HOST_DEVICE inline LiftedInt lifted_from(const IndexedBall& i, const IndexedBall& m) {
  return lifted_vector(i, i.radius, m, m.radius);
}

// Does ball m stay out of the orthosphere of four balls that are not in a plane, with ties as CGAL
// breaks them? Else the four make no tetrahedron of the triangulation.
ALPHASCOPE_HOST_DEVICE inline bool stays_out(const IndexedBall (&corners)[4],
                                             const IndexedBall& m) {
  for (const IndexedBall& v : corners) {
    if (v.x == m.x && v.y == m.y && v.z == m.z)
      return v.radius != m.radius ? v.radius > m.radius : v.index < m.index;
  }
  const IndexedBall& i = corners[0];
  return orthocentre_cut<WideInt<4>>(lifted_from(i, corners[1]), lifted_from(i, corners[2]),
                                     {0, lifted_from(i, corners[3])}, lifted_from(i, m)) < 0;
}

}  // namespace alphascope
