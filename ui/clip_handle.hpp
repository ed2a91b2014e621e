// SPDX-License-Identifier: GPL-3.0-or-later
// The handle by which the mouse moves and turns a clip in the picture. An arrow across the cut
// moves it; a ring in the cut turns it. These functions compute where arrow and ring lie in the
// picture, and how a drag changes the clip. Pure geometry: neither ImGui nor VTK.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace alphascope {

struct Clip;

using PicturePoint = std::array<double, 2>;  // pixels, from the top left of the picture

// The view of a picture. Positions are in Å, in the coordinates of the file; vectors have length 1.
struct HandleView {
  std::array<double, 3> right{1, 0, 0}, up{0, 1, 0}, towards_viewer{0, 0, 1};
  // Returns the pixel that shows a point; empty if the point is behind the viewer.
  std::function<std::optional<PicturePoint>(const std::array<double, 3>&)> seen;
};

struct ClipHandle {
  bool shown = false;
  std::array<double, 3> pivot{};  // Å, a point of the cut; middle of the handle
  HandleView view;
  double pixels_per_angstrom = 1;  // at the pivot, across the line of sight
  double ring_radius = 0;          // pixels, of the ring seen from the front
  PicturePoint middle{}, tip{};    // ends of the arrow, which points to the side that is cut away
  std::vector<PicturePoint> ring;  // a closed polygon
};

// `size` is the distance from the middle to the ring, in pixels.
ClipHandle make_clip_handle(const Clip& clip, const std::array<double, 3>& pivot,
                            const HandleView& view, double size);

enum class HandlePart : std::uint8_t { none, move, turn };
// The part of the handle within `reach` pixels of the mouse.
HandlePart part_at(const ClipHandle& handle, const PicturePoint& mouse, double reach);

// The clip after the mouse has dragged `part` by so many pixels (y downwards). A drag up or down
// moves a cut that is seen from the front.
Clip dragged(const Clip& clip, const ClipHandle& handle, HandlePart part, const PicturePoint& by);

// The point of the cut nearest to `middle`, Å.
std::array<double, 3> pivot_near(const Clip& clip, const std::array<double, 3>& middle);

}  // namespace alphascope
