// SPDX-License-Identifier: GPL-3.0-or-later
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
  std::vector<Colour> colours = {};  // one for each point; empty: all have `colour`

  const Colour& colour_of(std::size_t point) const {
    return colours.empty() ? colour : colours[point];
  }
};

// The provenance of the meshes: keys and values, all printable.
using MeshHeader = std::vector<std::pair<std::string, std::string>>;

// PLY: binary, little-endian, coordinates in single precision, with one list of vertices and one of
// faces. Both have the number of their mesh, from 1, as property `mesh`. Vertices have colours.
void write_ply(const std::vector<Mesh>& meshes, const MeshHeader& header, AtomicFile& file,
               const RunContext& context = {});

// OBJ: text with all digits of the coordinates, and an object for each mesh. Colours follow the
// coordinates of a vertex, as MeshLab, Blender and others read them.
void write_obj(const std::vector<Mesh>& meshes, const MeshHeader& header, AtomicFile& file,
               const RunContext& context = {});

// OFF: text with all digits of the coordinates, in one list. Vertices have colours (COFF).
void write_off(const std::vector<Mesh>& meshes, const MeshHeader& header, AtomicFile& file,
               const RunContext& context = {});

// STL: text with all digits of the coordinates, and a solid for each mesh. STL has no colours or
// comments. Only four entries of the header are written, after the names of the solids. These are
// the file's SHA-256, alpha, solvent radius and the complex' hash.
void write_stl(const std::vector<Mesh>& meshes, const MeshHeader& header, AtomicFile& file,
               const RunContext& context = {});

// GLB: binary glTF 2.0, coordinates in single precision. Each mesh with triangles has a node. The
// header is in `asset.extras`. Coordinates are Å, not glTF's metres, and axes are those of the
// molecule.
void write_glb(const std::vector<Mesh>& meshes, const MeshHeader& header, AtomicFile& file,
               const RunContext& context = {});

// None of these functions commits the file. All throw WriteError and Cancelled.

}  // namespace alphascope
