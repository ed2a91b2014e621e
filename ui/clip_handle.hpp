// The handle by which the mouse moves and turns a clip in the picture: an arrow across the cut
// moves it, a ring in the cut turns it. Where they are in the picture, and what a drag of them
// does. Pure geometry: neither ImGui nor VTK.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/document/settings/clip.hpp"

namespace alphascope {

using PicturePoint = std::array<double, 2>;  // pixels, from the top left of the picture

// How the picture is looked at. Places in Å, in the coordinates of the file; vectors of length 1.
struct HandleView {
  std::array<double, 3> right{1, 0, 0}, up{0, 1, 0}, towards_viewer{0, 0, 1};
  // Where a place is seen; nothing: behind the viewer.
  std::function<std::optional<PicturePoint>(const std::array<double, 3>&)> seen;
};

struct ClipHandle {
  bool shown = false;
  std::array<double, 3> pivot{};  // Å; in the cut, in the middle of the handle
  HandleView view;
  double pixels_per_angstrom = 1;  // at the pivot, across the line of sight
  double ring_radius = 0;          // pixels, of the ring seen from the front
  PicturePoint middle{}, tip{};    // of the arrow, which points to what is cut away
  std::vector<PicturePoint> ring;  // closed
};

// `size`: pixels from the middle to the ring.
ClipHandle make_clip_handle(const Clip& clip, const std::array<double, 3>& pivot,
                            const HandleView& view, double size);

enum class HandlePart : std::uint8_t { none, move, turn };
// What the mouse holds there, if it is not farther than `reach` pixels from it.
HandlePart part_at(const ClipHandle& handle, const PicturePoint& mouse, double reach);

// What becomes of the clip when the mouse, holding that part, goes by so many pixels (y downwards).
// A cut that one looks at straight is moved by going up and down.
Clip dragged(const Clip& clip, const ClipHandle& handle, HandlePart part, const PicturePoint& by);

// The point of the cut that is nearest to `middle`.
std::array<double, 3> pivot_near(const Clip& clip, const std::array<double, 3>& middle);

}  // namespace alphascope
