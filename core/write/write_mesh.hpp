// Coloured triangle meshes for programs that draw, print or compute with them.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/files/atomic_file.hpp"
#include "core/geometry/real_point.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

struct Mesh {
  using Colour = std::array<std::uint8_t, 3>;  // sRGB

  std::string name;               // printable
  std::vector<RealPoint> points;  // Å
  std::vector<std::array<std::uint32_t, 3>> triangles;
  Colour colour{};
  std::vector<Colour> colours = {};  // one a point; empty: all have `colour`

  const Colour& colour_of(std::size_t point) const {
    return colours.empty() ? colour : colours[point];
  }
};

// Where the meshes come from: keys and values, all printable.
using MeshHeader = std::vector<std::pair<std::string, std::string>>;

// Binary, little-endian, coordinates in single precision: one list of vertices and one of faces.
// Both have the number of their mesh, from 1, as the property `mesh`; vertices have colours.
void write_ply(const std::vector<Mesh>& meshes, const MeshHeader& header, AtomicFile& file,
               const RunContext& context = {});

// Text with all digits of the coordinates. An object for each mesh; colours follow the coordinates
// of a vertex, as MeshLab, Blender and others read them.
void write_obj(const std::vector<Mesh>& meshes, const MeshHeader& header, AtomicFile& file,
               const RunContext& context = {});

// Text with all digits of the coordinates, in one list; vertices have colours (COFF).
void write_off(const std::vector<Mesh>& meshes, const MeshHeader& header, AtomicFile& file,
               const RunContext& context = {});

// Text with all digits of the coordinates, a solid for each mesh. STL has neither colours nor
// comments: of the header, only the file's hash, alpha, solvent radius and the complex' hash are
// there, behind the names of the solids.
void write_stl(const std::vector<Mesh>& meshes, const MeshHeader& header, AtomicFile& file,
               const RunContext& context = {});

// Binary glTF 2.0, coordinates in single precision: a node and mesh for each that has triangles;
// the header is in `asset.extras`. Coordinates are Å, not glTF's metres, and axes those of the
// molecule.
void write_glb(const std::vector<Mesh>& meshes, const MeshHeader& header, AtomicFile& file,
               const RunContext& context = {});

// None commits. They throw WriteError, and Cancelled.

}  // namespace alphascope
