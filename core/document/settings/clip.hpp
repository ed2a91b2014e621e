// SPDX-License-Identifier: GPL-3.0-or-later
// The clip that cuts the picture open: a plane, or a slab between two planes. It is a setting of
// the display, so nothing is computed anew. This also reads and writes clips as text, and keeps
// clips under names.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/document/commands/number_input.hpp"

namespace alphascope {

// Lengths in Å, positions in the coordinates of the file.
struct Clip {
  enum class Kind : std::uint8_t { off, plane, slab };
  Kind kind = Kind::off;
  std::array<double, 3> normal{0, 0, 1};  // of length 1
  // Points x of the plane, or of the middle of the slab, have normal · x = position.
  double position = 0;
  double thickness = 10;  // of the slab
  bool flipped = false;   // of a plane: keeps the side that the normal points to, instead of the
                          // other

  bool on() const { return kind != Kind::off; }
  friend bool operator==(const Clip&, const Clip&) = default;
};

// A clip saved under a name. Undo and session files include it, as all settings.
struct NamedClip {
  std::string name;
  Clip clip;
  friend bool operator==(const NamedClip&, const NamedClip&) = default;
};
using NamedClips = std::vector<NamedClip>;

// The clip of this name; null if there is none.
const NamedClip* find_clip(const NamedClips& clips, const std::string& name);
// Saves the clip. An older one of that name is replaced.
void save_clip(NamedClips& clips, const NamedClip& clip);

inline constexpr NumberRule kClipPositionRule{"The position", -1e6, 1e6, "Å"};
inline constexpr NumberRule kClipThicknessRule{"The thickness", 0.1, 1e6, "Å"};

// The kept points x have normal · x + offset >= 0.
struct HalfSpace {
  std::array<double, 3> normal{};
  double offset = 0;

  template <class Point>
  double depth(const Point& x) const {  // Å inside; negative: outside
    return normal[0] * x[0] + normal[1] * x[1] + normal[2] * x[2] + offset;
  }
  friend bool operator==(const HalfSpace&, const HalfSpace&) = default;
};

// The half-spaces that a clip keeps: none if it is off, one for a plane, two for a slab.
std::vector<HalfSpace> kept_half_spaces(const Clip& clip);

// The same clip with another normal (not 0; any length), through the point `pivot`.
Clip turned(const Clip& clip, std::array<double, 3> normal, const std::array<double, 3>& pivot);

// A clip as written. Parts of it may depend on the molecule and on the view.
struct ClipWords {
  Clip clip;
  bool along_view = false;  // the normal is the direction towards the viewer
  bool has_position = false;
  std::string error;  // a sentence with the remedy; empty: the text is valid

  // `towards_viewer` has length 1. Without a position the plane passes through `middle`.
  Clip resolved(const std::array<double, 3>& towards_viewer,
                const std::array<double, 3>& middle) const;
};

// Reads "x", "z=12.5" (Å), "-y=3" (keeps points beyond y = 3), "view", "1,1,0=5", "x=12.5:8" (a
// slab of 8 Å around x = 12.5) or "off".
ClipWords read_clip(const std::string& text);
inline constexpr const char* kClipForms =
    "x, y=12.5, -z=3, view, 1,1,0=5, or with a thickness x=12.5:8; or off";

// The text from which read_clip() makes the same clip. It has the thickness of a slab only.
std::string clip_text(const Clip& clip);

// "x", "-y": the axis of the normal; empty: no axis.
std::string axis_name(const std::array<double, 3>& normal);

}  // namespace alphascope
