// Coloured triangle meshes as PLY and as binary glTF (GLB), for programs that draw.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/geometry/real_point.hpp"
#include "core/io/atomic_file.hpp"

namespace alphascope {

struct Mesh {
  std::string name;               // printable
  std::vector<RealPoint> points;  // Å; written in single precision
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::array<std::uint8_t, 3> colour{};  // sRGB
};

// Where the meshes come from: keys and values, all printable.
using MeshHeader = std::vector<std::pair<std::string, std::string>>;

// Binary, little-endian: one list of vertices and one of faces. Both have the number of their mesh,
// from 1, as the property `mesh`; vertices have colours.
void write_ply(const std::vector<Mesh>& meshes, const MeshHeader& header, AtomicFile& file);

// glTF 2.0: a node, mesh and material for each that has triangles; the header is in `asset.extras`.
// Coordinates are Å, not glTF's metres, and axes those of the molecule.
void write_glb(const std::vector<Mesh>& meshes, const MeshHeader& header, AtomicFile& file);

// Both do not commit, and throw WriteError.

}  // namespace alphascope
