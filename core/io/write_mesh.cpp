#include "core/io/write_mesh.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>

namespace alphascope {
namespace {

static_assert(std::endian::native == std::endian::little);

template <class T>
void append_bytes(std::string& to, T value) {
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  to.append(bytes, sizeof value);
}

std::array<float, 3> floats(const RealPoint& p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

std::string ply_head(const std::vector<Mesh>& meshes, const MeshHeader& header) {
  std::size_t points = 0, triangles = 0;
  for (const Mesh& mesh : meshes) {
    points += mesh.points.size();
    triangles += mesh.triangles.size();
  }
  std::string text = "ply\nformat binary_little_endian 1.0\n";
  for (const auto& [key, value] : header) text += "comment " + key + " " + value + "\n";
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    text += "comment mesh " + std::to_string(m + 1) + " " + meshes[m].name + "\n";
  }
  return text + "element vertex " + std::to_string(points) +
         "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\n"
         "property uchar green\nproperty uchar blue\nproperty int mesh\nelement face " +
         std::to_string(triangles) +
         "\nproperty list uchar int vertex_indices\nproperty int mesh\nend_header\n";
}

// --- GLB

std::string quoted(const std::string& printable_text) {
  std::string text = "\"";
  for (const char c : printable_text) {
    if (c == '"' || c == '\\') text += '\\';
    text += c;
  }
  return text + "\"";
}

std::string number(double value) {
  char buffer[48];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

// glTF's colours are linear.
std::string colour_text(const std::array<std::uint8_t, 3>& colour) {
  std::string text = "[";
  for (const std::uint8_t c : colour) {
    const double s = c / 255.0;
    text += number(s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4)) + ",";
  }
  return text + "1]";
}

std::string list(const std::vector<std::string>& items) {
  std::string text = "[";
  for (std::size_t n = 0; n < items.size(); ++n) text += (n ? "," : "") + items[n];
  return text + "]";
}

// Fills both chunks as meshes come.
class Glb {
 public:
  void add(const Mesh& mesh) {
    const std::string n = std::to_string(nodes_.size());
    add_points(mesh.points);
    add_triangles(mesh.triangles);
    materials_.push_back("{\"name\":" + quoted(mesh.name) +
                         ",\"doubleSided\":true,\"pbrMetallicRoughness\":{\"baseColorFactor\":" +
                         colour_text(mesh.colour) +
                         ",\"metallicFactor\":0,\"roughnessFactor\":0.6}}");
    const std::string points = std::to_string(accessors_.size() - 2),
                      triangles = std::to_string(accessors_.size() - 1);
    meshes_.push_back("{\"name\":" + quoted(mesh.name) +
                      ",\"primitives\":[{\"attributes\":{\"POSITION\":" + points +
                      "},\"indices\":" + triangles + ",\"material\":" + n + "}]}");
    nodes_.push_back("{\"name\":" + quoted(mesh.name) + ",\"mesh\":" + n + "}");
  }

  std::string file(const MeshHeader& header) const {
    std::vector<std::string> extras, indices;
    for (const auto& [key, value] : header) extras.push_back(list({quoted(key), quoted(value)}));
    for (std::size_t n = 0; n < nodes_.size(); ++n) indices.push_back(std::to_string(n));
    std::string json =
        "{\"asset\":{\"version\":\"2.0\",\"generator\":\"alphascope\",\"extras\":{\"header\":" +
        list(extras) + "}},\"scene\":0,\"scenes\":[{";
    // An empty list is no glTF.
    if (!nodes_.empty()) {
      json += "\"nodes\":" + list(indices) + "}],\"nodes\":" + list(nodes_) +
              ",\"meshes\":" + list(meshes_) + ",\"materials\":" + list(materials_) +
              ",\"accessors\":" + list(accessors_) + ",\"bufferViews\":" + list(views_) +
              ",\"buffers\":[{\"byteLength\":" + std::to_string(data_.size()) + "}]}";
    } else {
      json += "}]}";
    }
    json.resize((json.size() + 3) / 4 * 4, ' ');
    std::string all;
    const std::size_t size = 20 + json.size() + (data_.empty() ? 0 : 8 + data_.size());
    if (size > std::numeric_limits<std::uint32_t>::max()) {
      throw WriteError("The surfaces are too large for a GLB file. Write PLY instead.");
    }
    const auto append = [&](std::uint32_t n) { append_bytes(all, n); };
    append(0x46546C67);  // "glTF"
    append(2);
    append(static_cast<std::uint32_t>(size));
    append(static_cast<std::uint32_t>(json.size()));
    append(0x4E4F534A);  // "JSON"
    all += json;
    if (data_.empty()) return all;
    append(static_cast<std::uint32_t>(data_.size()));
    append(0x004E4942);  // "BIN"
    return all + data_;
  }

 private:
  void add_view(std::size_t begin, int target) {
    views_.push_back("{\"buffer\":0,\"byteOffset\":" + std::to_string(begin) +
                     ",\"byteLength\":" + std::to_string(data_.size() - begin) +
                     ",\"target\":" + std::to_string(target) + "}");
  }
  std::string accessor(int component, std::size_t count, const char* type) const {
    return "{\"bufferView\":" + std::to_string(views_.size() - 1) +
           ",\"componentType\":" + std::to_string(component) +
           ",\"count\":" + std::to_string(count) + ",\"type\":\"" + type + "\"";
  }
  void add_points(const std::vector<RealPoint>& points) {
    constexpr int kFloat = 5126, kArrayBuffer = 34962;
    const std::size_t begin = data_.size();
    std::array<float, 3> low, high;
    low.fill(std::numeric_limits<float>::max());
    high.fill(std::numeric_limits<float>::lowest());
    for (const RealPoint& p : points) {
      const std::array<float, 3> at = floats(p);
      for (std::size_t k = 0; k < 3; ++k) {
        append_bytes(data_, at[k]);
        low[k] = std::min(low[k], at[k]);
        high[k] = std::max(high[k], at[k]);
      }
    }
    add_view(begin, kArrayBuffer);
    const auto corner = [](const std::array<float, 3>& p) {
      return list({number(p[0]), number(p[1]), number(p[2])});
    };
    accessors_.push_back(accessor(kFloat, points.size(), "VEC3") + ",\"min\":" + corner(low) +
                         ",\"max\":" + corner(high) + "}");
  }
  void add_triangles(const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    constexpr int kUnsignedInt = 5125, kElementArrayBuffer = 34963;
    const std::size_t begin = data_.size();
    for (const auto& triangle : triangles) {
      for (const std::uint32_t v : triangle) append_bytes(data_, v);
    }
    add_view(begin, kElementArrayBuffer);
    accessors_.push_back(accessor(kUnsignedInt, 3 * triangles.size(), "SCALAR") + "}");
  }

  std::string data_;
  std::vector<std::string> nodes_, meshes_, materials_, accessors_, views_;
};

}  // namespace

void write_ply(const std::vector<Mesh>& meshes, const MeshHeader& header, AtomicFile& file) {
  file.write(ply_head(meshes, header));
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    std::string block;
    for (const RealPoint& p : meshes[m].points) {
      for (const float x : floats(p)) append_bytes(block, x);
      for (const std::uint8_t c : meshes[m].colour) append_bytes(block, c);
      append_bytes(block, static_cast<std::int32_t>(m + 1));
    }
    file.write(block);
  }
  std::uint32_t before = 0;
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    std::string block;
    for (const auto& triangle : meshes[m].triangles) {
      append_bytes(block, std::uint8_t{3});
      for (const std::uint32_t v : triangle) append_bytes(block, before + v);
      append_bytes(block, static_cast<std::int32_t>(m + 1));
    }
    before += static_cast<std::uint32_t>(meshes[m].points.size());
    file.write(block);
  }
}

void write_glb(const std::vector<Mesh>& meshes, const MeshHeader& header, AtomicFile& file) {
  Glb glb;
  for (const Mesh& mesh : meshes) {
    if (!mesh.triangles.empty()) glb.add(mesh);
  }
  file.write(glb.file(header));
}

}  // namespace alphascope
