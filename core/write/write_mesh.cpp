// SPDX-License-Identifier: GPL-3.0-or-later
// Writes meshes as PLY, OBJ, OFF and STL. GLB is in write_glb.cpp.
#include "core/write/write_mesh.hpp"

#include <algorithm>
#include <cmath>

#include "core/geometry/lattice_alpha.hpp"
#include "core/write/text_writer.hpp"

namespace alphascope {
namespace {

// The number of meshes named in the head of a PLY file, because readers read it line by line.
constexpr std::size_t kMostNamed = 1000;

std::size_t all_points(const std::vector<Mesh>& meshes) {
  std::size_t points = 0;
  for (const Mesh& mesh : meshes) points += mesh.points.size();
  return points;
}

std::size_t all_triangles(const std::vector<Mesh>& meshes) {
  std::size_t triangles = 0;
  for (const Mesh& mesh : meshes) triangles += mesh.triangles.size();
  return triangles;
}

// Calls write(mesh, number of points before it, its index) for each mesh.
template <class Write>
void for_meshes(const std::vector<Mesh>& meshes, const RunContext& context, const Write& write) {
  std::size_t before = 0;
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    context.report("writing", static_cast<double>(m) / static_cast<double>(meshes.size()));
    write(meshes[m], before, m);
    before += meshes[m].points.size();
  }
}

void comments(TextWriter& text, const MeshHeader& header, const char* before) {
  for (const auto& [key, value] : header) {
    text << before << key << " " << value;
    text.end_line();
  }
}

void coordinates(TextWriter& text, const RealPoint& p) {
  text.shortest(p.x) << " ";
  text.shortest(p.y) << " ";
  text.shortest(p.z);
}

}  // namespace

void write_ply(const std::vector<Mesh>& meshes, const MeshHeader& header, AtomicFile& file,
               const RunContext& context) {
  TextWriter text(file, context.cancel);
  text << "ply\nformat binary_little_endian 1.0\n";
  comments(text, header, "comment ");
  for (std::size_t m = 0; m < std::min(meshes.size(), kMostNamed); ++m) {
    text << "comment mesh " << m + 1 << " " << meshes[m].name;
    text.end_line();
  }
  text << "element vertex " << all_points(meshes)
       << "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\n"
          "property uchar green\nproperty uchar blue\nproperty int mesh\nelement face "
       << all_triangles(meshes)
       << "\nproperty list uchar int vertex_indices\nproperty int mesh\nend_header\n";
  for_meshes(meshes, context, [&](const Mesh& mesh, std::size_t, std::size_t m) {
    for (std::size_t n = 0; n < mesh.points.size(); ++n) {
      const RealPoint& p = mesh.points[n];
      for (const double x : {p.x, p.y, p.z}) text.bytes(static_cast<float>(x));
      text.bytes(mesh.colour_of(n)).bytes(static_cast<std::int32_t>(m + 1));
    }
  });
  for_meshes(meshes, context, [&](const Mesh& mesh, std::size_t before, std::size_t m) {
    for (const auto& triangle : mesh.triangles) {
      text.bytes(std::uint8_t{3});
      for (const std::uint32_t v : triangle) text.bytes(static_cast<std::uint32_t>(before + v));
      text.bytes(static_cast<std::int32_t>(m + 1));
    }
  });
  text.flush();
}

void write_obj(const std::vector<Mesh>& meshes, const MeshHeader& header, AtomicFile& file,
               const RunContext& context) {
  TextWriter text(file, context.cancel);
  comments(text, header, "# ");
  for_meshes(meshes, context, [&](const Mesh& mesh, std::size_t before, std::size_t) {
    text << "o " << mesh.name;
    text.end_line();
    for (std::size_t n = 0; n < mesh.points.size(); ++n) {
      text << "v ";
      coordinates(text, mesh.points[n]);
      for (const std::uint8_t c : mesh.colour_of(n)) {
        (text << " ").shortest(std::round(c / 255.0 * 1e4) / 1e4);
      }
      text.end_line();
    }
    for (const auto& triangle : mesh.triangles) {
      text << "f";
      for (const std::uint32_t v : triangle) text << " " << before + v + 1;
      text.end_line();
    }
  });
  text.flush();
}

void write_off(const std::vector<Mesh>& meshes, const MeshHeader& header, AtomicFile& file,
               const RunContext& context) {
  TextWriter text(file, context.cancel);
  text << "COFF\n";
  comments(text, header, "# ");
  text << all_points(meshes) << " " << all_triangles(meshes) << " 0\n";
  for_meshes(meshes, context, [&](const Mesh& mesh, std::size_t, std::size_t) {
    for (std::size_t n = 0; n < mesh.points.size(); ++n) {
      coordinates(text, mesh.points[n]);
      for (const std::uint8_t c : mesh.colour_of(n)) text << " " << std::size_t{c};
      text << " 255";
      text.end_line();
    }
  });
  for_meshes(meshes, context, [&](const Mesh& mesh, std::size_t before, std::size_t) {
    for (const auto& triangle : mesh.triangles) {
      text << "3";
      for (const std::uint32_t v : triangle) text << " " << before + v;
      text.end_line();
    }
  });
  text.flush();
}

void write_stl(const std::vector<Mesh>& meshes, const MeshHeader& header, AtomicFile& file,
               const RunContext& context) {
  // Only some entries are written, because readers take lines of up to 255 characters.
  std::string source;
  for (const char* key : {"sha256", "alpha_angstrom2", "solvent_radius_angstrom", "hash"}) {
    const auto found = std::find_if(header.begin(), header.end(),
                                    [&](const auto& entry) { return entry.first == key; });
    if (found != header.end()) source += " " + found->first + "=" + found->second;
  }
  TextWriter text(file, context.cancel);
  for_meshes(meshes, context, [&](const Mesh& mesh, std::size_t, std::size_t) {
    text << "solid " << mesh.name << source;
    text.end_line();
    for (const auto& [a, b, c] : mesh.triangles) {
      const RealPoint& p = mesh.points[a];
      text << "facet normal ";
      const RealPoint normal = unit_vector(cross(mesh.points[b] - p, mesh.points[c] - p));
      text << normal.x << " " << normal.y << " " << normal.z;
      text << "\nouter loop\n";
      for (const std::uint32_t v : {a, b, c}) {
        text << "vertex ";
        coordinates(text, mesh.points[v]);
        text.end_line();
      }
      text << "endloop\nendfacet\n";
    }
    text << "endsolid " << mesh.name;
    text.end_line();
  });
  text.flush();
}

}  // namespace alphascope
