// SPDX-License-Identifier: GPL-3.0-or-later
// The surface of a cartoon: ribbons for helices, arrows for strands, tubes for the rest. Pure C++;
// no VTK.
#pragma once

#include <cstdint>
#include <vector>

#include "core/run/cancel_token.hpp"
#include "ui/scene/mesh/tube_mesh.hpp"
#include "ui/scene/objects/cartoon_trace.hpp"

namespace alphascope {

inline constexpr double kRungRadius = 0.35;  // Å, of ladders

// A closed surface. Its triangles come in bands of one length; all triangles of a band belong to
// one residue. The plates of bases follow.
struct CartoonMesh {
  SmoothMesh surface;
  std::vector<std::uint32_t> atom_of_band;  // as TracePoint::atom
  std::size_t triangles_of_band = 1;
  std::vector<std::uint32_t> atom_of_plate_triangle;  // as BasePlate::atom
  std::size_t triangles() const { return surface.corners.size() / 3; }
  std::uint32_t atom_of(std::size_t triangle) const {
    const std::size_t bands = atom_of_band.size() * triangles_of_band;
    return triangle < bands ? atom_of_band[triangle / triangles_of_band]
                            : atom_of_plate_triangle[triangle - bands];
  }
};

// How finely the surface is made: steps from one residue to the next, and points around.
struct CartoonDetail {
  int steps = 8, around = 16;  // steps: a power of two, so that places are exact; around: a
                               // multiple of 4, at least 8
};
// Coarser for more residues, as each of them is smaller in the picture.
CartoonDetail cartoon_detail(std::size_t residues);

// Works on the caller's threads. Throws Cancelled.
CartoonMesh build_cartoon(const std::vector<Trace>& traces, const CartoonDetail& detail,
                          const CancelToken& cancel = {});

void add_plates(const std::vector<BasePlate>& plates, CartoonMesh& mesh);

// Upper bound of the number of points of build_cartoon(), without making any.
std::size_t cartoon_points(const std::vector<Trace>& traces, const CartoonDetail& detail);

}  // namespace alphascope
