// SPDX-License-Identifier: GPL-3.0-or-later
// Keys that the panels use, as codes that reach ImGui 1.86, which has no names for them. They are
// GLFW's codes; glfw_host.cpp checks that.
#pragma once

#include <optional>
#include <string_view>

namespace alphascope::key {

inline constexpr int k0 = 48;
inline constexpr int kA = 65, kB = 66, kC = 67, kE = 69, kF = 70, kL = 76, kO = 79, kQ = 81,
                     kR = 82;
inline constexpr int kP = 80;
inline constexpr int kS = 83, kT = 84, kV = 86, kX = 88, kY = 89, kZ = 90, kSpace = 32;
inline constexpr int kEscape = 256, kEnter = 257, kTab = 258, kBackspace = 259;
inline constexpr int kInsert = 260, kDelete = 261, kPageUp = 266, kPageDown = 267;
inline constexpr int kRight = 262, kLeft = 263, kDown = 264, kUp = 265, kHome = 268, kEnd = 269;
inline constexpr int kF1 = 290;
inline constexpr int kFirstKeypad = 320, kKeypadEnter = 335;
inline constexpr int kLeftShift = 340, kLeftControl = 341, kLeftAlt = 342, kLeftSuper = 343;
inline constexpr int kRightShift = 344, kRightControl = 345, kRightAlt = 346, kRightSuper = 347;
inline constexpr int kMenu = 348;
inline constexpr int kFirstModifier = kLeftShift, kLastModifier = kRightSuper;

// Keys pressed together.
struct Chord {
  int code = 0;
  bool control = false, shift = false;

  bool arrow() const { return code >= kRight && code <= kUp; }
};

// Reads "Ctrl+Shift+Z", "esc", "PageUp", "F1" or "7", in upper or lower case. Empty if there is no
// such key.
std::optional<Chord> read_chord(std::string_view text);

// Whether the chord was pressed in this frame. Arrow keys repeat while they are held.
bool pressed(const Chord& chord);

}  // namespace alphascope::key
