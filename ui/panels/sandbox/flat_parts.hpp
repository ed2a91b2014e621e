// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of the flat drawing, for its own sources only: the paper, its shapes and the mouse on it.
#pragma once

#include <imgui.h>

#include "core/chart/flat_drawing.hpp"

namespace alphascope {

struct PanelContext;
struct SandboxState;

// Converts between the paper (Å, y upwards) and the window (pixels). The state holds the place of
// the paper.
class FlatPaper {
 public:
  FlatPaper(SandboxState& memory, ImVec2 corner, ImVec2 size)
      : memory_(memory), corner_(corner), size_(size) {}

  void fit(const FlatBox& box);
  ImVec2 pixel(const FlatPoint& p) const;
  FlatPoint place(ImVec2 pixel) const;
  float pixels(double angstrom) const;
  // Zooms, and keeps the place under the mouse.
  void zoom(ImVec2 mouse, double factor);
  // Returns a box a little larger than the visible one, so that no cell ends in sight.
  FlatBox box() const;

 private:
  SandboxState& memory_;
  ImVec2 corner_, size_;
};

// --- flat_shapes.cpp

void draw_flat_shape(PanelContext& ctx, const FlatPaper& paper, const FlatShape& shape);

// --- flat_marks.cpp

// Outlines balls whose place or radius differs from the drawing.
void draw_moved_balls(PanelContext& ctx, const FlatPaper& paper);
// Marks selected balls, and the ball under the mouse with its place and radius.
void draw_flat_marks(PanelContext& ctx, const FlatPaper& paper);

// --- flat_mouse.cpp

// Takes the mouse within the rectangle: it moves, resizes and adds balls, and moves the paper.
void flat_mouse(PanelContext& ctx, FlatPaper& paper, ImVec2 corner, ImVec2 size);

}  // namespace alphascope
