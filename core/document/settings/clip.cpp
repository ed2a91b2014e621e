// SPDX-License-Identifier: GPL-3.0-or-later
// Computes the half-spaces that a clip keeps, and reads and writes clips as text.
#include "core/document/settings/clip.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/geometry/shortest_number.hpp"
#include "core/text/text_parts.hpp"

namespace alphascope {
namespace {

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

std::optional<Vector> unit(Vector v) {
  const double length = std::hypot(v[0], v[1], v[2]);
  if (!(length > 0) || !std::isfinite(length)) return std::nullopt;
  for (double& x : v) x /= length;
  return v;
}

// Returns the text before the first `mark`, and leaves in `text` the part after it. `found` tells
// whether there is a mark.
std::string cut_at(std::string& text, char mark, bool& found) {
  const std::size_t at = text.find(mark);
  found = at != std::string::npos;
  std::string before = text.substr(0, at);
  text = found ? text.substr(at + 1) : "";
  return before;
}

std::optional<Vector> read_direction(const std::string& text) {
  for (int axis = 0; axis < 3; ++axis) {
    Vector v{};
    v[static_cast<std::size_t>(axis)] = 1;
    if (text == std::string(1, static_cast<char>('x' + axis))) return v;
  }
  const std::vector<std::string> words = parts_of(text, ',');
  if (words.size() != 3) return std::nullopt;
  Vector v{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto number = read_number(words[axis], {"A component", -1e6, 1e6}).value;
    if (!number) return std::nullopt;
    v[axis] = *number;
  }
  return unit(v);
}

ClipWords not_a_clip(const std::string& text) {
  ClipWords words;
  words.error = "\"" + text + "\" is not a clip. Write " + kClipForms + ".";
  return words;
}

}  // namespace

std::vector<HalfSpace> kept_half_spaces(const Clip& clip) {
  const Vector& n = clip.normal;
  const HalfSpace before{n, -clip.position}, behind{{-n[0], -n[1], -n[2]}, clip.position};
  switch (clip.kind) {
    case Clip::Kind::off:
      return {};
    case Clip::Kind::plane:
      return {clip.flipped ? before : behind};
    case Clip::Kind::slab:
      break;
  }
  const double half = clip.thickness / 2;
  return {{behind.normal, behind.offset + half}, {before.normal, before.offset + half}};
}

Clip turned(const Clip& clip, std::array<double, 3> normal, const std::array<double, 3>& pivot) {
  Clip result = clip;
  result.normal = unit(normal).value_or(clip.normal);
  result.position = dot(result.normal, pivot);
  return result;
}

Clip ClipWords::resolved(const std::array<double, 3>& towards_viewer,
                         const std::array<double, 3>& middle) const {
  Clip result = clip;
  if (along_view) result.normal = towards_viewer;
  if (!has_position) result.position = dot(result.normal, middle);
  return result;
}

ClipWords read_clip(const std::string& text) {
  ClipWords words;
  if (text == "off") return words;
  bool has_thickness = false;
  std::string rest = text;
  std::string place = cut_at(rest, ':', has_thickness);
  const std::string thickness = rest;
  std::string direction = cut_at(place, '=', words.has_position);
  words.clip.kind = has_thickness ? Clip::Kind::slab : Clip::Kind::plane;
  const auto take_sign = [&] {
    words.clip.flipped = true;
    direction.erase(0, 1);
  };
  // In three numbers the minus sign belongs to the first number; otherwise it flips the plane.
  if (direction.starts_with('-') && direction.find(',') == std::string::npos) take_sign();
  words.along_view = direction == "view";
  const auto normal = read_direction(direction);
  if (!words.along_view && !normal) return not_a_clip(text);
  if (normal) words.clip.normal = *normal;
  const auto number = [&words](const std::string& typed, const NumberRule& rule, double& value) {
    const NumberInput input = read_number(typed, rule);
    if (input.value) value = *input.value;
    if (!input.error.empty()) words.error = input.error;
  };
  if (words.has_position) number(place, kClipPositionRule, words.clip.position);
  if (has_thickness) number(thickness, kClipThicknessRule, words.clip.thickness);
  return words;
}

std::string axis_name(const std::array<double, 3>& normal) {
  for (int axis = 0; axis < 3; ++axis) {
    const double along = normal[static_cast<std::size_t>(axis)];
    const std::string name(1, static_cast<char>('x' + axis));
    if (along == 1) return name;
    if (along == -1) return "-" + name;
  }
  return {};
}

std::string clip_text(const Clip& clip) {
  if (!clip.on()) return "off";
  Vector n = clip.normal;
  double position = clip.position;
  const bool plane = clip.kind == Clip::Kind::plane;
  std::string direction = axis_name(n);
  // "-x" stands for a flipped plane. So a normal along -x is written as x, with the other side.
  bool flipped = plane && clip.flipped;
  if (direction.starts_with('-')) {
    direction.erase(0, 1);
    position = -position;
    flipped = plane && !flipped;
  } else if (direction.empty() && flipped) {
    for (double& x : n) x = -x;
    position = -position;
    flipped = false;
  }
  if (direction.empty()) {
    direction = shortest_number(n[0]) + "," + shortest_number(n[1]) + "," + shortest_number(n[2]);
  }
  std::string text = (flipped ? "-" : "") + direction + "=" + shortest_number(position);
  if (!plane) text += ":" + shortest_number(clip.thickness);
  return text;
}

const NamedClip* find_clip(const NamedClips& clips, const std::string& name) {
  const auto found = std::find_if(clips.begin(), clips.end(),
                                  [&](const NamedClip& clip) { return clip.name == name; });
  return found == clips.end() ? nullptr : &*found;
}

void save_clip(NamedClips& clips, const NamedClip& clip) {
  for (NamedClip& old : clips) {
    if (old.name != clip.name) continue;
    old = clip;
    return;
  }
  clips.push_back(clip);
}

}  // namespace alphascope
