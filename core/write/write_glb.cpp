// SPDX-License-Identifier: GPL-3.0-or-later
// Writes binary glTF 2.0: a head in JSON that describes all data, then the data. The head follows
// from sizes and bounds alone, so the data need not be in memory at once.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "core/geometry/lattice_alpha.hpp"
#include "core/write/text_writer.hpp"
#include "core/write/write_mesh.hpp"

namespace alphascope {
namespace {

std::array<float, 3> floats(const RealPoint& p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

std::string quoted(const std::string& printable_text) {
  std::string text = "\"";
  for (const char c : printable_text) {
    if (c == '"' || c == '\\') text += '\\';
    text += c;
  }
  return text + "\"";
}

template <class Number>
std::string number(Number value) {
  char buffer[48];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

// An sRGB component as glTF's linear colour, 0 to 1.
double linear(std::uint8_t srgb) {
  const double s = srgb / 255.0;
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}
// 16 bits, because 8 bits would not distinguish dark linear colours.
std::uint16_t linear_short(std::uint8_t srgb) {
  return static_cast<std::uint16_t>(std::lround(65535 * linear(srgb)));
}

std::string list(const std::vector<std::string>& items) {
  std::string text = "[";
  for (std::size_t n = 0; n < items.size(); ++n) text += (n ? "," : "") + items[n];
  return text + "]";
}

// The JSON chunk. It grows by add().
class Head {
 public:
  void add(const Mesh& mesh) {
    const std::string n = std::to_string(nodes_.size());
    std::string attributes = "\"POSITION\":" + add_points(mesh.points);
    if (!mesh.colours.empty()) {
      const std::string colours = add_accessor(kUnsignedShort, mesh.colours.size(), "VEC4",
                                               kArrayBuffer, 8 * mesh.colours.size());
      accessors_.back() += ",\"normalized\":true}";
      attributes += ",\"COLOR_0\":" + colours;
    }
    const std::string indices = add_accessor(kUnsignedInt, 3 * mesh.triangles.size(), "SCALAR",
                                             kElementArrayBuffer, 12 * mesh.triangles.size());
    accessors_.back() += "}";
    meshes_.push_back("{\"name\":" + quoted(mesh.name) + ",\"primitives\":[{\"attributes\":{" +
                      attributes + "},\"indices\":" + indices +
                      ",\"material\":" + material_of(mesh) + "}]}");
    nodes_.push_back("{\"name\":" + quoted(mesh.name) + ",\"mesh\":" + n + "}");
  }

  std::string text(const MeshHeader& header) const {
    std::vector<std::string> extras, indices;
    for (const auto& [key, value] : header) extras.push_back(list({quoted(key), quoted(value)}));
    for (std::size_t n = 0; n < nodes_.size(); ++n) indices.push_back(std::to_string(n));
    std::string json =
        "{\"asset\":{\"version\":\"2.0\",\"generator\":\"alphascope\",\"extras\":{\"header\":" +
        list(extras) + "}},\"scene\":0,\"scenes\":[{";
    // glTF does not allow empty lists.
    if (!nodes_.empty()) {
      json += "\"nodes\":" + list(indices) + "}],\"nodes\":" + list(nodes_) +
              ",\"meshes\":" + list(meshes_) + ",\"materials\":" + list(materials_) +
              ",\"accessors\":" + list(accessors_) + ",\"bufferViews\":" + list(views_) +
              ",\"buffers\":[{\"byteLength\":" + std::to_string(bytes_) + "}]}";
    } else {
      json += "}]}";
    }
    json.resize((json.size() + 3) / 4 * 4, ' ');
    return json;
  }
  std::size_t bytes() const { return bytes_; }  // size of the data

 private:
  static constexpr int kFloat = 5126, kUnsignedShort = 5123, kUnsignedInt = 5125;
  static constexpr int kArrayBuffer = 34962, kElementArrayBuffer = 34963;

  // Adds an accessor for the next `bytes` of the data. Its JSON object is left open for further
  // members.
  std::string add_accessor(int component, std::size_t count, const char* type, int target,
                           std::size_t bytes) {
    accessors_.push_back("{\"bufferView\":" + std::to_string(views_.size()) +
                         ",\"componentType\":" + std::to_string(component) +
                         ",\"count\":" + std::to_string(count) + ",\"type\":\"" + type + "\"");
    views_.push_back("{\"buffer\":0,\"byteOffset\":" + std::to_string(bytes_) + ",\"byteLength\":" +
                     std::to_string(bytes) + ",\"target\":" + std::to_string(target) + "}");
    bytes_ += bytes;
    return std::to_string(accessors_.size() - 1);
  }

  std::string add_points(const std::vector<RealPoint>& points) {
    std::array<float, 3> low, high;
    low.fill(std::numeric_limits<float>::max());
    high.fill(std::numeric_limits<float>::lowest());
    for (const RealPoint& p : points) {
      const std::array<float, 3> at = floats(p);
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], at[k]);
        high[k] = std::max(high[k], at[k]);
      }
    }
    const auto corner = [](const std::array<float, 3>& p) {
      return list({number(p[0]), number(p[1]), number(p[2])});
    };
    const std::string index =
        add_accessor(kFloat, points.size(), "VEC3", kArrayBuffer, 12 * points.size());
    accessors_.back() += ",\"min\":" + corner(low) + ",\"max\":" + corner(high) + "}";
    return index;
  }

  // glTF multiplies colours of vertices by the material's colour. So all meshes with such colours
  // share a white material.
  std::string material_of(const Mesh& mesh) {
    const bool own = mesh.colours.empty();
    if (!own && !white_.empty()) return white_;
    std::string colour = "[";
    for (const std::uint8_t c : mesh.colour) colour += number(own ? linear(c) : 1.0) + ",";
    materials_.push_back("{\"name\":" + quoted(own ? mesh.name : "colours of vertices") +
                         ",\"doubleSided\":true,\"pbrMetallicRoughness\":{\"baseColorFactor\":" +
                         colour + "1],\"metallicFactor\":0,\"roughnessFactor\":0.6}}");
    const std::string index = std::to_string(materials_.size() - 1);
    if (!own) white_ = index;
    return index;
  }

  std::size_t bytes_ = 0;
  std::string white_;
  std::vector<std::string> nodes_, meshes_, materials_, accessors_, views_;
};

// Writes the data in the order of Head::add().
void write_data(const Mesh& mesh, TextWriter& to) {
  for (const RealPoint& p : mesh.points) to.bytes(floats(p));
  for (const Mesh::Colour& c : mesh.colours) {
    to.bytes(std::array<std::uint16_t, 4>{linear_short(c[0]), linear_short(c[1]),
                                          linear_short(c[2]), 65535});
  }
  for (const auto& triangle : mesh.triangles) to.bytes(triangle);
}

}  // namespace

void write_glb(const std::vector<Mesh>& meshes, const MeshHeader& header, AtomicFile& file,
               const RunContext& context) {
  Head head;
  for (const Mesh& mesh : meshes) {
    if (!mesh.triangles.empty()) head.add(mesh);
  }
  const std::string json = head.text(header);
  const std::size_t size = 20 + json.size() + (head.bytes() == 0 ? 0 : 8 + head.bytes());
  if (size > std::numeric_limits<std::uint32_t>::max()) {
    throw WriteError("The surfaces are too large for a GLB file. Write PLY instead.");
  }
  TextWriter to(file, context.cancel);
  const auto word = [&](std::size_t n) { to.bytes(static_cast<std::uint32_t>(n)); };
  word(0x46546C67);  // "glTF"
  word(2);
  word(size);
  word(json.size());
  word(0x4E4F534A);  // "JSON"
  to << json;
  if (head.bytes() > 0) {
    word(head.bytes());
    word(0x004E4942);  // "BIN"
  }
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    context.report("writing", static_cast<double>(m) / static_cast<double>(meshes.size()));
    if (!meshes[m].triangles.empty()) write_data(meshes[m], to);
  }
  to.flush();
}

}  // namespace alphascope
