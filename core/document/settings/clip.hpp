// Where the picture is cut open: a plane, behind which everything is kept, or a slab between two
// planes. A setting of display only: nothing is computed anew. Also how it is written as text.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/document/commands/number_input.hpp"

namespace alphascope {

// Lengths in Å, places in the coordinates of the file.
struct Clip {
  enum class Kind : std::uint8_t { off, plane, slab };
  Kind kind = Kind::off;
  std::array<double, 3> normal{0, 0, 1};  // of length 1
  // Of the plane, or of the middle of the slab: its points x have normal · x = position.
  double position = 0;
  double thickness = 10;  // of the slab
  bool flipped = false;   // of a plane: what is before it is kept, not what is behind it

  bool on() const { return kind != Kind::off; }
  friend bool operator==(const Clip&, const Clip&) = default;
};

inline constexpr NumberRule kClipPositionRule{"The position", -1e6, 1e6, "Å"};
inline constexpr NumberRule kClipThicknessRule{"The thickness", 0.1, 1e6, "Å"};

// What is kept: points x with normal · x + offset >= 0.
struct HalfSpace {
  std::array<double, 3> normal{};
  double offset = 0;

  template <class Point>
  double depth(const Point& x) const {  // Å inside; negative: outside
    return normal[0] * x[0] + normal[1] * x[1] + normal[2] * x[2] + offset;
  }
  friend bool operator==(const HalfSpace&, const HalfSpace&) = default;
};

// None when the clip is off, one of a plane, two of a slab.
std::vector<HalfSpace> kept_by(const Clip& clip);

// The same cut with another normal (of any length but 0) through the point `pivot`.
Clip turned(const Clip& clip, std::array<double, 3> normal, const std::array<double, 3>& pivot);

// What was written, some of it relative to the molecule and to how it is looked at.
struct ClipWords {
  Clip clip;
  bool along_view = false;  // the normal is the direction towards the viewer
  bool has_position = false;
  std::string error;  // a sentence with the remedy; empty: the rest holds

  // `towards_viewer`: of length 1. Without a position the cut goes through `middle`.
  Clip resolved(const std::array<double, 3>& towards_viewer,
                const std::array<double, 3>& middle) const;
};

// "x", "z=12.5" (Å), "-y=3" (what is beyond y = 3 is kept), "view", "1,1,0=5", "x=12.5:8" (a slab
// of 8 Å around x = 12.5), "off".
ClipWords read_clip(const std::string& text);
inline constexpr const char* kClipForms =
    "x, y=12.5, -z=3, view, 1,1,0=5, or with a thickness x=12.5:8; or off";

// As read_clip() reads it; the same clip again, but for the thickness of what is no slab.
std::string clip_text(const Clip& clip);

// "x", "-y": the axis along which the normal is; empty: along none.
std::string axis_name(const std::array<double, 3>& normal);

}  // namespace alphascope
