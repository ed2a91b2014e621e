// How much memory a picture of a complex takes, and what of it is drawn when that is more than
// there is: VTK and OpenGL drivers end the program where an allocation fails. Pure; no VTK.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/complex/compare.hpp"
#include "ui/scene/mesh/complex_mesh.hpp"
#include "ui/scene/mesh/layer_mesh.hpp"

namespace alphascope {

struct DrawingTask {
  std::size_t balls = 0;                    // whose arrays are not there yet
  const AlphaComplex* complex = nullptr;    // null: none
  const Comparison* differences = nullptr;  // to be drawn; null: none
  MeshOptions mesh;                         // what is wanted of the complex
};

// Bytes from before build_mesh() to the first pictures, at most: plain arrays, VTK's, and OpenGL's
// buffers, which software drivers and processors with graphics inside keep in the same memory.
std::uint64_t drawing_bytes(const DrawingTask& task);

// Of what is free, the rest being for the window and for computing the next complex meanwhile.
std::uint64_t drawing_budget(std::uint64_t free_bytes);

// Of a picture for a file itself, with ambient occlusion. The second
// throws std::runtime_error where that and `more_bytes` do not fit.
std::uint64_t picture_bytes(int width, int height);
void require_room(int width, int height, std::optional<std::uint64_t> free_bytes,
                  std::uint64_t more_bytes = 0);

// Of VTK's and OpenGL's arrays for what has its plain arrays already: another scene shows it, too.
std::uint64_t second_scene_bytes(std::size_t balls, const ComplexMesh* mesh);

// Of what panels want drawn, as drawing_bytes().
std::uint64_t layer_bytes(const LayerPoints& points);
// Why nothing of it is drawn and what to do; empty where it fits.
std::string layers_not_drawn_text(const LayerPoints& points, std::optional<std::uint64_t> free);

// Of all arrays of what is drawn.
std::uint64_t drawn_bytes(std::size_t balls, const ComplexMesh* mesh);

// Why OpenGL cannot draw this mesh, and what to do, where it indexes at most so many cells or
// balls; empty: it can. Older drivers draw something else then, and say nothing.
std::string beyond_opengl_text(const ComplexMesh& mesh, std::size_t balls, std::size_t most);

struct DrawingPlan {
  MeshOptions mesh;  // of what is drawn
  bool differences = false;
  bool balls = true;                  // false: nothing at all is drawn
  std::vector<std::string> left_out;  // "edges"; least important last; empty: nothing is
  std::uint64_t wanted_bytes = 0, free_bytes = 0;
  bool complete() const { return balls && left_out.empty(); }
};

// Everything, if it fits into the budget, and when nobody knows what is free. Else what fits, in
// this order: balls (without them nothing), differences, tetrahedra, at least their outside,
// boundary, triangles, edges.
DrawingPlan plan_drawing(const DrawingTask& task, std::optional<std::uint64_t> free_bytes);

// What is not drawn, what it would take and what to do; empty when the plan is complete.
std::string not_drawn_text(const DrawingPlan& plan);

inline constexpr const char* kNothingDrawn = "Nothing is drawn: there is too little memory for it.";
inline constexpr const char* kShowLess =
    " fewer chains or a smaller assembly, or close other programs.";

}  // namespace alphascope
