// How long a move of alpha takes, from the command to the end of the first frame that shows it.
#pragma once

#include <string>

#include "ui/window/imgui_frame.hpp"

namespace alphascope {

class Viewer;

// Moves alpha to `angstrom2` again and again, each time from a little beside it and when nothing
// else goes on; frames come as in Viewer::run(). One line: median and longest, in ms, of the whole
// and of each stage, and the hash of what is shown. Throws std::runtime_error when a picture does
// not come within five minutes, or when two moves lead to different complexes.
std::string time_alpha_moves(Viewer& viewer, ScriptedInput& input, double angstrom2, int moves);

}  // namespace alphascope
