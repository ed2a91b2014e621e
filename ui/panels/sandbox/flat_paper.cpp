// SPDX-License-Identifier: GPL-3.0-or-later
// The place and the scale of the flat drawing in the window.
#include <algorithm>

#include "ui/panels/sandbox/flat_parts.hpp"
#include "ui/panels/sandbox/sandbox_state.hpp"

namespace alphascope {
namespace {

constexpr double kLeastPixels = 0.05, kMostPixels = 20000;  // pixels for 1 Å

}  // namespace

void FlatPaper::fit(const FlatBox& box) {
  memory_.middle = {(box.low[0] + box.high[0]) / 2, (box.low[1] + box.high[1]) / 2};
  memory_.pixels_per_angstrom = std::clamp(std::min(size_.x / box.width(), size_.y / box.height()),
                                           kLeastPixels, kMostPixels);
}

ImVec2 FlatPaper::pixel(const FlatPoint& p) const {
  const double scale = memory_.pixels_per_angstrom;
  return {corner_.x + static_cast<float>(size_.x / 2 + (p[0] - memory_.middle[0]) * scale),
          corner_.y + static_cast<float>(size_.y / 2 - (p[1] - memory_.middle[1]) * scale)};
}

FlatPoint FlatPaper::place(ImVec2 pixel) const {
  const double scale = memory_.pixels_per_angstrom;
  return {memory_.middle[0] + (pixel.x - corner_.x - size_.x / 2) / scale,
          memory_.middle[1] - (pixel.y - corner_.y - size_.y / 2) / scale};
}

float FlatPaper::pixels(double angstrom) const {
  return static_cast<float>(angstrom * memory_.pixels_per_angstrom);
}

void FlatPaper::zoom(ImVec2 mouse, double factor) {
  const FlatPoint before = place(mouse);
  memory_.pixels_per_angstrom =
      std::clamp(memory_.pixels_per_angstrom * factor, kLeastPixels, kMostPixels);
  const FlatPoint after = place(mouse);
  for (int d = 0; d < 2; ++d) memory_.middle[d] += before[d] - after[d];
}

FlatBox FlatPaper::box() const {
  constexpr float kBeyond = 8;
  const FlatPoint low = place({corner_.x - kBeyond, corner_.y + size_.y + kBeyond});
  return {low, place({corner_.x + size_.x + kBeyond, corner_.y - kBeyond})};
}

}  // namespace alphascope
