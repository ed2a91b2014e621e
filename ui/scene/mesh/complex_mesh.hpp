// What is drawn of an alpha complex, as arrays that go to the GPU as they are: a simplex is the
// indices of its balls and a colour. Pure C++, may run in a worker; no VTK.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/complex/alpha_complex.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/run/cancel_token.hpp"
#include "core/triangulation/outer_faces.hpp"
#include "ui/scene/mesh/alpha_scale.hpp"
#include "ui/scene/mesh/ball_geometry.hpp"
#include "ui/scene/mesh/packed_colour.hpp"

namespace alphascope {

// Not ColourBy: element and chain are one to a mesh, since each ball brings its colour.
enum class ComplexColouring : std::uint8_t {
  single,  // one colour for each kind of simplex
  // Every simplex in the colour that most of its corners have; on a tie, of the corner with the
  // lowest ball index. A face of a tetrahedron has the tetrahedron's colour. Colours of elements
  // and chains are names: a blend of two of them would be a third name.
  balls,
  alpha,    // by alpha value
  classes,  // singular, regular or interior
};

// Of the display controls, what needs another mesh: a change of the others must not make one.
struct MeshOptions {
  bool tetrahedra = true;
  bool boundary = false;  // faces that belong to exactly one tetrahedron
  bool triangles = false;
  bool edges = false;
  bool singular_only = true;  // triangles and edges that are faces of nothing larger
  // Share of the way from each corner to the tetrahedron's centre, 0 (touching) to below 1.
  double shrink = 0;
  // Faces between two tetrahedra cannot be seen when nothing is translucent or shrunk; then they
  // are left out.
  bool translucent = false;
  bool smooth_boundary = false;  // normals of balls, between which light is interpolated
  ComplexColouring colouring = ComplexColouring::balls;
  Rgb8 single_colour{90, 169, 230};
  AlphaColours alpha_colours{};

  // Of tetrahedra, all four faces.
  bool whole_tetrahedra() const { return tetrahedra && (shrink > 0 || translucent); }
  // Of tetrahedra, the faces that no other one has.
  bool outside() const { return (tetrahedra && !whole_tetrahedra()) || boundary; }
  friend bool operator==(const MeshOptions&, const MeshOptions&) = default;
};

// Points in Å relative to BallGeometry::origin; `corners` of them make one cell (3 or 2).
struct CellSoup {
  std::vector<float> xyz;
  std::vector<std::uint8_t> rgb;
  // What each cell is: of caps, 4 × tetrahedron. Empty: cell i is i.
  std::vector<std::uint32_t> source;
  std::size_t points() const { return xyz.size() / 3; }
};

// 16 bytes, which a shader fetches at once.
struct DrawnFace {
  std::array<BallIndex, 3> balls{};
  PackedColour colour{};
};
static_assert(sizeof(DrawnFace) == 16);

// Triangles with corners at centres of balls.
struct FaceCells {
  ResultArray<DrawnFace> faces;
  // What each is: of faces of tetrahedra the FaceCode; of triangles the place in their list. Empty:
  // face i is i.
  ResultArray<std::uint32_t> source;
  // Of every ball, outward: the mean of the faces around it, by their areas. Empty: faces are flat.
  std::vector<std::array<float, 3>> normals;
  std::size_t size() const { return faces.size(); }
};

struct DrawnEdge {
  std::array<BallIndex, 2> balls{};
  PackedColour colour{};
  std::uint32_t unused = 0;  // a shader fetches four numbers
};
static_assert(sizeof(DrawnEdge) == 16);

struct EdgeCells {
  ResultArray<DrawnEdge> edges;
  // The place of each in the complex' list. Empty: cell i is i.
  ResultArray<std::uint32_t> source;
  std::size_t size() const { return edges.size(); }
};

// Tetrahedra with their four faces, each drawn towards its centre.
struct TetrahedronCells {
  Simplices<4> balls;
  ResultArray<PackedColour> colours;  // one a tetrahedron
  // The place of each in the complex' list. Empty: cell i is i.
  ResultArray<std::uint32_t> source;
  float shrink = 0;  // as in MeshOptions
  std::size_t size() const { return balls.size(); }
};

struct ComplexMesh {
  // Of tetrahedra either their faces outside or all of each.
  FaceCells outside;
  TetrahedronCells tetrahedra;
  FaceCells boundary, triangles;
  EdgeCells edges;
  std::size_t tetrahedra_drawn = 0;  // all tetrahedra of the complex, or 0 when off
  std::optional<AlphaScale> scale;   // what its colours mean, if they are of alpha values
  // Triangles that a GPU draws.
  std::size_t faces_drawn() const {
    return outside.size() + 4 * tetrahedra.size() + boundary.size() + triangles.size();
  }
  bool empty() const { return faces_drawn() == 0 && edges.size() == 0; }
};

// `colours` holds one colour a ball. Throws std::invalid_argument when complex, balls and colours
// do not belong together (a vertex index beyond the balls), and Cancelled. Where a
// triangle is regular by its class and belongs to no tetrahedron, the classes are not used. Classes
// are those of space or of the balls' own dimension (core/complex/own_dimension.hpp). The
// same for any number of threads; it uses those of the caller's task arena.
ComplexMesh build_mesh(const BallGeometry& balls, const std::vector<Rgb8>& colours,
                       const AlphaComplex& complex, const MeshOptions& options,
                       const CancelToken& cancel = {});

// Where the corners of a tetrahedron are drawn; `shrink` as in MeshOptions.
std::array<std::array<float, 3>, 4> shrunk_corners(const BallGeometry& balls,
                                                   const std::array<BallIndex, 4>& tetrahedron,
                                                   float shrink);

// Faces that occur in exactly one of the tetrahedra; corners ordered so that the normal points away
// from the tetrahedron.
Simplices<3> boundary_faces(const BallGeometry& balls, const Simplices<4>& tetrahedra);

}  // namespace alphascope
