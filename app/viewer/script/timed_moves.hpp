// How long a move of alpha, or of a ball by hand, takes: from the command to the end of the first
// frame that shows it. Lines for scripts: median and longest, in ms, of the whole and of the
// engine.
#pragma once

#include <string>

#include "ui/window/imgui_frame.hpp"

namespace alphascope {

class Viewer;

// Moves alpha to `angstrom2` again and again, each time from a little beside it and when nothing
// else goes on, two more times before it counts; frames come as in Viewer::run(). Also of each
// stage, and the hash of what is shown. Throws std::runtime_error when a picture does not come
// within five minutes, or when two moves lead to different complexes.
std::string time_alpha_moves(Viewer& viewer, ScriptedInput& input, double angstrom2, int moves);

// Moves balls of the open sandbox in turn, each by a little, in the plane if it is flat; also the
// time of a frame in which nothing is new. Throws std::runtime_error when there is no sandbox with
// a ball, and when a picture does not come within five minutes.
std::string time_ball_moves(Viewer& viewer, ScriptedInput& input, int moves);

}  // namespace alphascope
