// SPDX-License-Identifier: GPL-3.0-or-later
// Geometry of the clip's handle: its shape in the picture, and drags of it.
#include "ui/clip_handle.hpp"

#include <algorithm>
#include <cmath>

#include "core/document/settings/clip.hpp"
#include "core/geometry/alpha.hpp"
#include "core/geometry/real_point.hpp"

namespace alphascope {
namespace {

using Vector = std::array<double, 3>;

constexpr int kRingPoints = 64;
constexpr double kArrowShare = 0.7;  // of the ring's radius
// Compares the length of 1 Å along the normal, in pixels, with 1 Å across the line of sight. Below
// this ratio the cut is seen almost from the front. Its normal then has no useful direction in the
// picture.
constexpr double kFacing = 0.2;

RealPoint real(const Vector& v) {
  return {v[0], v[1], v[2]};
}
Vector vector(const RealPoint& p) {
  return {p.x, p.y, p.z};
}
double size(const PicturePoint& p) {
  return std::hypot(p[0], p[1]);
}
PicturePoint between(const PicturePoint& a, const PicturePoint& b) {
  return {b[0] - a[0], b[1] - a[1]};
}

double distance_to_segment(const PicturePoint& p, const PicturePoint& a, const PicturePoint& b) {
  const PicturePoint along = between(a, b), from = between(a, p);
  const double length2 = along[0] * along[0] + along[1] * along[1];
  double share = length2 > 0 ? (along[0] * from[0] + along[1] * from[1]) / length2 : 0;
  share = std::clamp(share, 0.0, 1.0);
  return std::hypot(from[0] - share * along[0], from[1] - share * along[1]);
}

Clip moved(const Clip& clip, const ClipHandle& h, const PicturePoint& by) {
  Clip result = clip;
  const auto further = h.view.seen(vector(real(h.pivot) + real(clip.normal)));
  const PicturePoint along = further ? between(h.middle, *further) : PicturePoint{};
  if (size(along) > kFacing * h.pixels_per_angstrom) {
    result.position += (along[0] * by[0] + along[1] * by[1]) / (size(along) * size(along));
  } else {
    const bool towards = dot(real(clip.normal), real(h.view.towards_viewer)) > 0;
    result.position += (towards ? -by[1] : by[1]) / h.pixels_per_angstrom;
  }
  return result;
}

// Turns the clip as a ball of the ring's radius would turn under the mouse. Uses Rodrigues'
// formula.
Clip turned_by(const Clip& clip, const ClipHandle& h, const PicturePoint& by) {
  const double angle = size(by) / std::max(1.0, h.ring_radius);
  const RealPoint axis = unit_vector(by[0] * real(h.view.up) + by[1] * real(h.view.right));
  const RealPoint n = real(clip.normal);
  const RealPoint turned_normal = std::cos(angle) * n + std::sin(angle) * cross(axis, n) +
                                  (dot(axis, n) * (1 - std::cos(angle))) * axis;
  return turned(clip, vector(turned_normal), h.pivot);
}

}  // namespace

std::array<double, 3> pivot_near(const Clip& clip, const std::array<double, 3>& middle) {
  const RealPoint m = real(middle), n = real(clip.normal);
  return vector(m + (clip.position - dot(n, m)) * n);
}

ClipHandle make_clip_handle(const Clip& clip, const std::array<double, 3>& pivot,
                            const HandleView& view, double size_in_pixels) {
  ClipHandle h;
  h.pivot = pivot;
  h.view = view;
  const RealPoint p = real(pivot);
  const auto middle = view.seen(pivot), beside = view.seen(vector(p + real(view.right)));
  if (!clip.on() || !middle || !beside) return h;
  h.middle = *middle;
  h.pixels_per_angstrom = size(between(h.middle, *beside));
  if (!(h.pixels_per_angstrom > 0)) return h;
  h.ring_radius = size_in_pixels;
  const double radius = size_in_pixels / h.pixels_per_angstrom;  // Å
  const double towards_cut = clip.kind == Clip::Kind::plane && clip.flipped ? -1 : 1;
  const RealPoint n = real(clip.normal);
  const auto tip = view.seen(vector(p + (kArrowShare * towards_cut * radius) * n));
  RealPoint first, second;
  normals_of(n, first, second);
  for (int i = 0; i <= kRingPoints; ++i) {
    const double angle = 2 * M_PI * i / kRingPoints;
    const auto point = view.seen(
        vector(p + (radius * std::cos(angle)) * first + (radius * std::sin(angle)) * second));
    if (point) h.ring.push_back(*point);
  }
  h.tip = tip.value_or(h.middle);
  h.shown = h.ring.size() == kRingPoints + 1;
  return h;
}

HandlePart part_at(const ClipHandle& handle, const PicturePoint& mouse, double reach) {
  if (!handle.shown) return HandlePart::none;
  if (distance_to_segment(mouse, handle.middle, handle.tip) <= reach) return HandlePart::move;
  for (std::size_t i = 1; i < handle.ring.size(); ++i) {
    if (distance_to_segment(mouse, handle.ring[i - 1], handle.ring[i]) <= reach) {
      return HandlePart::turn;
    }
  }
  return HandlePart::none;
}

Clip dragged(const Clip& clip, const ClipHandle& handle, HandlePart part, const PicturePoint& by) {
  if (!handle.shown || size(by) == 0) return clip;
  if (part == HandlePart::move) return moved(clip, handle, by);
  if (part == HandlePart::turn) return turned_by(clip, handle, by);
  return clip;
}

}  // namespace alphascope
