// SPDX-License-Identifier: GPL-3.0-or-later
// Times moves of alpha, or of a ball by hand. Each time ends with the first frame that shows the
// move. Returns lines for scripts: median and maximum in ms, of the whole and of the engine.
#pragma once

#include <string>

#include "ui/window/imgui_frame.hpp"

namespace alphascope {

class Viewer;

// Moves alpha to `angstrom2` (Å²) again and again. Each move starts close to it, when no other work
// runs, and frames come as in Viewer::run(). Two moves come first and are not counted. Also reports
// each stage, and the hash of the complex shown. Throws std::runtime_error when a picture takes
// more than five minutes, or when two moves lead to different complexes.
std::string time_alpha_moves(Viewer& viewer, ScriptedInput& input, double angstrom2, int moves);

// Moves balls of the open sandbox in turn, each by a little, in the plane if the sandbox is flat.
// Also reports the time of a frame without changes. Throws std::runtime_error when no sandbox with
// a ball is open, or when a picture takes more than five minutes.
std::string time_ball_moves(Viewer& viewer, ScriptedInput& input, int moves);

}  // namespace alphascope
