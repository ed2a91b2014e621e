// What the parts of a step (core/explain/ball_steps.hpp) are called: its counts, and what is drawn
// of it. For tables and legends.
#pragma once

#include <string>
#include <string_view>

#include "core/explain/ball_steps.hpp"

namespace alphascope {

// Of the list step_count: "balls in its cell", "with a ball in conflict". An id that is not there
// is shown with blanks.
std::string step_count_name(std::string_view id);
const char* step_mark_name(StepKind kind, StepMark mark);  // "kept", "valid", "in the cube"
const char* step_box_name(StepKind kind, StepMark mark);   // "cells that the cube meets"

}  // namespace alphascope
