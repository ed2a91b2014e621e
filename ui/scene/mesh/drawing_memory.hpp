// SPDX-License-Identifier: GPL-3.0-or-later
// Estimates the memory of a picture of a complex, and plans the parts to draw if not all fit.
// Without a plan, a failed allocation in VTK or an OpenGL driver would end the program. Pure C++;
// no VTK.
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
  std::size_t balls = 0;                    // balls whose arrays are not made yet
  const AlphaComplex* complex = nullptr;    // null: none
  const Comparison* differences = nullptr;  // null: none are drawn
  MeshOptions mesh;                         // the layers that the user wants
};

// Upper bound of the bytes in use from build_mesh() to the first pictures: plain arrays, VTK's
// arrays and OpenGL's buffers. Software OpenGL and integrated graphics keep those buffers in the
// same memory.
std::uint64_t drawing_bytes(const DrawingTask& task);

// Part of the free bytes that drawing may use. The rest is for the window and for computing the
// next complex.
std::uint64_t drawing_budget(std::uint64_t free_bytes);

// Bytes of a picture that is saved, with ambient occlusion. require_room() throws
// std::runtime_error if these and `more_bytes` do not fit into the budget.
std::uint64_t picture_bytes(int width, int height);
void require_room(int width, int height, std::optional<std::uint64_t> free_bytes,
                  std::uint64_t more_bytes = 0);

// Bytes of VTK's and OpenGL's arrays for a second scene that shows the same plain arrays.
std::uint64_t second_scene_bytes(std::size_t balls, const ComplexMesh* mesh);

// Bytes of the layers that panels ask for, as drawing_bytes().
std::uint64_t layer_bytes(const LayerPoints& points);
// The reason why layers are not drawn, and a remedy; empty if they fit.
std::string layers_not_drawn_text(const LayerPoints& points, std::optional<std::uint64_t> free);

// Bytes of all arrays of the present drawing.
std::uint64_t drawn_bytes(std::size_t balls, const ComplexMesh* mesh);

// The reason why OpenGL cannot draw this mesh, and a remedy. OpenGL can index at most `most` cells
// or balls. Empty if it can draw the mesh. Older drivers draw something wrong instead of reporting
// an error.
std::string beyond_opengl_text(const ComplexMesh& mesh, std::size_t balls, std::size_t most);

struct DrawingPlan {
  MeshOptions mesh;  // of the drawing
  bool differences = false;
  bool balls = true;                  // false: nothing at all is drawn
  std::vector<std::string> left_out;  // names such as "edges"; the least important is last; empty:
                                      // everything is drawn
  std::uint64_t wanted_bytes = 0, free_bytes = 0;
  bool complete() const { return balls && left_out.empty(); }
};

// Plans to draw everything if it fits into the budget, or if the free memory is unknown. Otherwise
// adds each part that fits: balls (without them nothing is drawn), differences, tetrahedra,
// boundary, triangles, edges. If tetrahedra do not fit, their outside is tried.
DrawingPlan plan_drawing(const DrawingTask& task, std::optional<std::uint64_t> free_bytes);

// The parts that are not drawn, the memory of the whole picture, and a remedy. Empty if the plan is
// complete.
std::string not_drawn_text(const DrawingPlan& plan);

inline constexpr const char* kNothingDrawn = "Nothing is drawn: there is too little memory for it.";
inline constexpr const char* kShowLess =
    " fewer chains or a smaller assembly, or close other programs.";

}  // namespace alphascope
