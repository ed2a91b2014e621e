// SPDX-License-Identifier: GPL-3.0-or-later
// The drawing of an alpha complex, as arrays that are uploaded to the GPU unchanged. A simplex is
// the indices of its balls and a colour. Pure C++, may run in a worker; no VTK.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/complex/alpha_complex.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/molecule/rgb8.hpp"
#include "core/run/cancel_token.hpp"
#include "core/triangulation/outer_faces.hpp"
#include "ui/scene/mesh/alpha_scale.hpp"
#include "ui/scene/mesh/ball_geometry.hpp"
#include "ui/scene/mesh/packed_colour.hpp"

namespace alphascope {

// How simplices are coloured. Unlike ColourBy, element and chain are one value here, since each
// ball has its colour already.
enum class ComplexColouring : std::uint8_t {
  single,  // one colour for each kind of simplex
  // Every simplex has the colour of most of its corners. On a tie the corner with the lowest ball
  // index decides. A face of a tetrahedron has the tetrahedron's colour. Colours are not blended,
  // because a blend could equal the colour of another element or chain.
  balls,
  alpha,    // by alpha value
  classes,  // singular, regular or interior
};

// The display controls that need another mesh when they change.
struct MeshOptions {
  bool tetrahedra = true;
  bool boundary = false;  // faces that belong to exactly one tetrahedron
  bool triangles = false;
  bool edges = false;
  bool singular_only = true;  // of triangles and edges, draws only those that are no face of a
                              // larger simplex
  // Share of the way from each corner to the tetrahedron's centre: 0 (touching) to below 1.
  double shrink = 0;
  // Whether tetrahedra are translucent. If they are neither translucent nor shrunk, faces between
  // two of them are invisible and left out.
  bool translucent = false;
  bool smooth_boundary = false;  // normals at balls, for smooth light
  ComplexColouring colouring = ComplexColouring::balls;
  Rgb8 single_colour{90, 169, 230};
  AlphaColours alpha_colours{};

  // Whether all four faces of each tetrahedron are drawn.
  bool whole_tetrahedra() const { return tetrahedra && (shrink > 0 || translucent); }
  // Whether faces of exactly one tetrahedron are drawn.
  bool outside() const { return (tetrahedra && !whole_tetrahedra()) || boundary; }
  friend bool operator==(const MeshOptions&, const MeshOptions&) = default;
};

// Triangles or lines without shared points. Points are in Å, relative to BallGeometry::origin;
// three or two consecutive points make a cell.
struct CellSoup {
  std::vector<float> xyz;
  std::vector<std::uint8_t> rgb;
  // Index that each cell stands for; in caps 4 × tetrahedron. Empty: cell i stands for i.
  std::vector<std::uint32_t> source;
  std::size_t points() const { return xyz.size() / 3; }
};

// 16 bytes, so that a shader fetches it in one read. Without initial values, which one thread would
// write before all fill the array.
struct DrawnFace {
  std::array<BallIndex, 3> balls;
  PackedColour colour;
};
static_assert(sizeof(DrawnFace) == 16);

// Triangles whose corners are centres of balls.
struct FaceCells {
  ResultArray<DrawnFace> faces;
  // Source of each face: for faces of tetrahedra the FaceCode, for triangles the index in the
  // complex' list. Empty: face i is triangle i.
  ResultArray<std::uint32_t> source;
  // Outward normals, one for each ball: the mean over its faces, weighted by area. Empty: light is
  // flat.
  std::vector<std::array<float, 3>> normals;
  std::size_t size() const { return faces.size(); }
};

struct DrawnEdge {
  std::array<BallIndex, 2> balls;
  PackedColour colour, other;  // of the halves at the first and the second ball
};
static_assert(sizeof(DrawnEdge) == 16);

struct EdgeCells {
  ResultArray<DrawnEdge> edges;
  // Index of each edge in the complex' list. Empty: cell i is edge i.
  ResultArray<std::uint32_t> source;
  std::size_t size() const { return edges.size(); }
};

// Tetrahedra with all four faces; `shrink` moves their corners towards their centres.
struct TetrahedronCells {
  Simplices<4> balls;
  ResultArray<PackedColour> colours;  // one a tetrahedron
  // Index of each tetrahedron in the complex' list. Empty: cell i is tetrahedron i.
  ResultArray<std::uint32_t> source;
  float shrink = 0;  // as in MeshOptions
  std::size_t size() const { return balls.size(); }
};

struct ComplexMesh {
  // Tetrahedra are drawn either by their outside faces or with all four faces each.
  FaceCells outside;
  TetrahedronCells tetrahedra;
  FaceCells boundary, triangles;
  EdgeCells edges;
  std::size_t tetrahedra_drawn = 0;  // all tetrahedra of the complex, or 0 when off
  std::optional<AlphaScale> scale;   // meaning of the colours, if they show alpha values
  // Number of triangles that the GPU draws.
  std::size_t faces_drawn() const {
    return outside.size() + 4 * tetrahedra.size() + boundary.size() + triangles.size();
  }
  bool empty() const { return faces_drawn() == 0 && edges.size() == 0; }
};

// `colours` has one colour for each ball. Throws std::invalid_argument if complex, balls and
// colours do not fit together (a vertex index beyond the balls), and Cancelled. The classes are not
// used if a triangle of class regular belongs to no tetrahedron. Classes are those of space or of
// the balls' own dimension (core/complex/own_dimension.hpp). Uses the threads of the caller's task
// arena; their number does not change the result.
ComplexMesh build_mesh(const BallGeometry& balls, const std::vector<Rgb8>& colours,
                       const AlphaComplex& complex, const MeshOptions& options,
                       const CancelToken& cancel = {});

// Corners of a tetrahedron as drawn (Å); `shrink` as in MeshOptions.
std::array<std::array<float, 3>, 4> shrunk_corners(const BallGeometry& balls,
                                                   const std::array<BallIndex, 4>& tetrahedron,
                                                   float shrink);

// Faces of exactly one of the tetrahedra. Their corners are ordered so that normals point away from
// the tetrahedron.
Simplices<3> boundary_faces(const BallGeometry& balls, const Simplices<4>& tetrahedra);

}  // namespace alphascope
