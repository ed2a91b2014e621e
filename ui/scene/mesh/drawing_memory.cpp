// SPDX-License-Identifier: GPL-3.0-or-later
// Estimates memory from measured constants. A program that only had a Scene measured the growth of
// its resident set (/proc/self/status). It measured from the empty scene to the end of three
// pictures. The pictures had 400 x 300 pixels, one of each quality. Scenes had 3 and 12 million
// points (balls: 1 and 4 million); a constant is the slope, rounded up. VTK 9.1 on llvmpipe (Mesa
// 22.3) keeps buffers in host memory, so no driver takes more of it.
#include "ui/scene/mesh/drawing_memory.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <stdexcept>

#include "core/geometry/lattice_alpha.hpp"
#include "core/run/parallel.hpp"
#include "core/text/grouped_number.hpp"

namespace alphascope {
namespace {

constexpr std::uint64_t kFace = 20;         // plain arrays of a face; drawing adds 16
constexpr std::uint64_t kFaceDrawn = 48;    // 36 (20 + 16), and room for a driver's copy
constexpr std::uint64_t kFaceSought = 32;   // while outer faces are searched
constexpr std::uint64_t kTetrahedron = 24;  // plain arrays of all four faces; drawing adds 20
constexpr std::uint64_t kTetrahedronDrawn = 56;
constexpr std::uint64_t kTetrahedronSorted = 112;  // for finding the outside without classes
constexpr std::uint64_t kSoupPoint = 15;           // plain arrays, contained in the next two
constexpr std::uint64_t kTrianglePoint = 150;      // 140 measured
constexpr std::uint64_t kLinePoint = 250;          // 233 measured: OpenGL draws lines as faces
constexpr std::uint64_t kBall = 110;               // 88 measured, and 13 that SceneController keeps
constexpr std::uint64_t kPicturePixel = 90;  // 80 measured, for PNG files of 2 to 19 million pixels
constexpr std::uint64_t kFixed = 128 << 20;  // 103 MB measured: shaders and the rasteriser's bins

struct Points {
  std::uint64_t faces = 0, lines = 0;  // points of triangles, of lines
};

// Counts with all threads, because a picture of a million balls waits for the result.
std::uint64_t count_of(SimplexClass wanted, const ResultArray<SimplexClass>& classes) {
  constexpr std::size_t kGrain = 65536;
  return parallel_sum(0, classes.size(), kGrain, [&](std::size_t first, std::size_t end) {
    const auto at = [&](std::size_t i) { return classes.begin() + static_cast<std::ptrdiff_t>(i); };
    return static_cast<std::uint64_t>(std::count(at(first), at(end), wanted));
  });
}

template <int N>
std::uint64_t cells(const SimplexList<N>& list, const MeshOptions& options) {
  if (!options.singular_only) return list.size();
  return count_of(SimplexClass::singular, list.classes);
}

// Faces of exactly one tetrahedron are regular triangles. Without a list of triangles, each face of
// each tetrahedron counts.
std::uint64_t outside_faces(const AlphaComplex& c) {
  if (c.tetrahedra_only) return 4 * c.tetrahedra.size();
  return count_of(SimplexClass::regular, c.triangles.classes);
}

// Number of edges and of faces that are not faces of whole tetrahedra; 16 bytes each.
std::uint64_t single_cells(const ComplexMesh& mesh) {
  return mesh.faces_drawn() - 4 * mesh.tetrahedra.size() + mesh.edges.size();
}

bool only_outside(const MeshOptions& mesh) {
  return mesh.shrink <= 0 && !mesh.translucent;
}

template <int N>
std::uint64_t size(const SetDifference<N>& d) {
  return d.missing.size() + d.extra.size();
}

void add_differences(const Comparison& c, Points& points) {
  points.faces += 12 * size(c.tetrahedra) + 3 * size(c.triangles) + 24 * size(c.vertices);
  points.lines += 2 * size(c.edges);
}

std::string size_text(std::uint64_t bytes) {
  char text[32];
  const double megabytes = static_cast<double>(bytes) / 1e6;
  const bool giga = megabytes >= 1000;
  std::snprintf(text, sizeof text, giga ? "%.1f GB" : "%.0f MB", megabytes / (giga ? 1000 : 1));
  return text;
}

std::string budget_text(std::uint64_t free_bytes) {
  if (drawing_budget(free_bytes) == 0)
    return "the " + size_text(free_bytes) + " of free memory are kept for the program itself";
  return "drawing may take " + size_text(drawing_budget(free_bytes)) + " of the " +
         size_text(free_bytes) + " that are free";
}

std::string remedy(const DrawingPlan& plan) {
  if (drawing_budget(plan.free_bytes) == 0) return "Close other programs.";
  return (plan.balls ? "Switch off other layers, or choose" : "Choose") + std::string(kShowLess);
}

// "edges", "triangles and edges", "tetrahedra, triangles and edges"
std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 < names.size() ? ", " : " and ";
    text += names[i];
  }
  return text;
}

// Adds one layer after another to the drawing, each if it fits into the budget.
class Planner {
 public:
  Planner(const DrawingTask& task, std::uint64_t budget)
      : wanted_(task), drawn_(task), budget_(budget) {
    drawn_.differences = nullptr;
    MeshOptions& m = drawn_.mesh;
    m.tetrahedra = m.boundary = m.triangles = m.edges = false;
  }

  DrawingPlan plan() {
    DrawingPlan plan;
    plan.balls = fits(drawn_);
    if (plan.balls) add_layers(plan.left_out);
    plan.mesh = drawn_.mesh;
    plan.differences = drawn_.differences != nullptr;
    return plan;
  }

 private:
  bool fits(const DrawingTask& task) const { return drawing_bytes(task) <= budget_; }

  bool add(const DrawingTask& more) {
    if (!fits(more)) return false;
    drawn_ = more;
    return true;
  }

  void add_layers(std::vector<std::string>& left_out) {
    DrawingTask more = drawn_;
    more.differences = wanted_.differences;
    if (!add(more)) left_out.emplace_back("differences from CGAL");
    if (wanted_.mesh.tetrahedra) add_tetrahedra(left_out);
    const auto add_layer = [&](bool MeshOptions::*layer, const char* name) {
      if (!(wanted_.mesh.*layer)) return;
      DrawingTask with = drawn_;
      with.mesh.*layer = true;
      if (!add(with)) left_out.emplace_back(name);
    };
    add_layer(&MeshOptions::boundary, "boundary");
    add_layer(&MeshOptions::triangles, "triangles");
    add_layer(&MeshOptions::edges, "edges");
  }

  void add_tetrahedra(std::vector<std::string>& left_out) {
    DrawingTask more = drawn_;
    more.mesh.tetrahedra = true;
    if (add(more)) return;
    const bool inside_wanted = !only_outside(more.mesh);
    more.mesh.shrink = 0;
    more.mesh.translucent = false;
    const bool outside = inside_wanted && add(more);
    left_out.emplace_back(outside ? "the inside of the tetrahedra" : "tetrahedra");
  }

  const DrawingTask& wanted_;
  DrawingTask drawn_;
  std::uint64_t budget_;
};

}  // namespace

std::uint64_t drawing_bytes(const DrawingTask& task) {
  Points points;
  std::uint64_t cells_plain = 0, cells_drawn = 0, seeking = 0;
  if (task.complex != nullptr) {
    const AlphaComplex& c = *task.complex;
    const MeshOptions& m = task.mesh;
    const std::uint64_t tetrahedra = c.tetrahedra.size();
    const bool outside = m.tetrahedra && only_outside(m);
    std::uint64_t faces = 0;
    if (outside || m.boundary) {
      const std::uint64_t all = outside_faces(c);
      faces = all * (outside + m.boundary);
      seeking = kFaceSought * all;
      if (c.tetrahedra_only) seeking += kTetrahedronSorted * tetrahedra;
    }
    if (m.triangles) faces += cells(c.triangles, m);
    if (m.edges) faces += cells(c.edges, m);  // an edge takes as much as a face
    const std::uint64_t whole = m.tetrahedra && !outside ? tetrahedra : 0;
    cells_plain = kFace * faces + kTetrahedron * whole;
    cells_drawn = kFaceDrawn * faces + kTetrahedronDrawn * whole;
  }
  if (task.differences != nullptr) add_differences(*task.differences, points);
  const std::uint64_t plain = cells_plain + kSoupPoint * (points.faces + points.lines);
  const std::uint64_t drawn =
      cells_drawn + kTrianglePoint * points.faces + kLinePoint * points.lines;
  return kBall * task.balls + std::max(plain + seeking, drawn);
}

std::uint64_t drawing_budget(std::uint64_t free_bytes) {
  return free_bytes > kFixed ? (free_bytes - kFixed) / 4 * 3 : 0;
}

std::uint64_t picture_bytes(int width, int height) {
  return kPicturePixel * static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
}

std::uint64_t second_scene_bytes(std::size_t balls, const ComplexMesh* mesh) {
  std::uint64_t bytes = kBall * balls;
  if (mesh == nullptr) return bytes;
  return bytes + (kFaceDrawn - kFace) * single_cells(*mesh) +
         (kTetrahedronDrawn - kTetrahedron) * mesh->tetrahedra.size();
}

std::uint64_t drawn_bytes(std::size_t balls, const ComplexMesh* mesh) {
  const std::uint64_t drawn = second_scene_bytes(balls, mesh);
  if (mesh == nullptr) return drawn;
  return drawn + kFace * single_cells(*mesh) + kTetrahedron * mesh->tetrahedra.size();
}

std::uint64_t layer_bytes(const LayerPoints& points) {
  return kTrianglePoint * points.faces + kLinePoint * points.lines + kBall * points.balls;
}

std::string layers_not_drawn_text(const LayerPoints& points, std::optional<std::uint64_t> free) {
  const std::uint64_t bytes = layer_bytes(points);
  if (!free || bytes <= drawing_budget(*free)) return {};
  return "The drawings of the page below need too much memory: about " + size_text(bytes) + "; " +
         budget_text(*free) + ". Select fewer items, or close other programs.";
}

void require_room(int width, int height, std::optional<std::uint64_t> free_bytes,
                  std::uint64_t more_bytes) {
  const std::uint64_t bytes = picture_bytes(width, height) + more_bytes;
  if (!free_bytes || bytes <= drawing_budget(*free_bytes)) return;
  throw std::runtime_error("There is too little memory for a picture of " + std::to_string(width) +
                           " x " + std::to_string(height) + " pixels. It takes about " +
                           size_text(bytes) + "; " + budget_text(*free_bytes) +
                           ". Choose a smaller size or free memory.");
}

DrawingPlan plan_drawing(const DrawingTask& task, std::optional<std::uint64_t> free_bytes) {
  DrawingPlan plan;
  plan.mesh = task.mesh;
  plan.differences = task.differences != nullptr;
  plan.wanted_bytes = drawing_bytes(task);
  plan.free_bytes = free_bytes.value_or(0);
  if (!free_bytes || plan.wanted_bytes <= drawing_budget(*free_bytes)) return plan;
  DrawingPlan less = Planner(task, drawing_budget(*free_bytes)).plan();
  less.wanted_bytes = plan.wanted_bytes;
  less.free_bytes = plan.free_bytes;
  return less;
}

std::string not_drawn_text(const DrawingPlan& plan) {
  if (plan.complete()) return {};
  const std::string what =
      plan.balls ? "Not drawn for lack of memory: " + listed(plan.left_out) + "." : kNothingDrawn;
  return what + " The whole picture takes about " + size_text(plan.wanted_bytes) + "; " +
         budget_text(plan.free_bytes) + ". " + remedy(plan);
}

std::string beyond_opengl_text(const ComplexMesh& mesh, std::size_t balls, std::size_t most) {
  const std::size_t largest =
      std::max({mesh.outside.size(), mesh.tetrahedra.size(), mesh.boundary.size(),
                mesh.triangles.size(), mesh.edges.size(), mesh.empty() ? 0 : balls});
  if (largest <= most) return {};
  return "The complex is not drawn: OpenGL on this machine draws at most " + grouped(most) +
         " faces, edges or balls of one kind, and this complex has " + grouped(largest) +
         ". Hide atoms, select fewer, or choose a smaller alpha; a newer driver may draw more.";
}

}  // namespace alphascope
