// SPDX-License-Identifier: GPL-3.0-or-later
// Names of the parts of a step (core/explain/ball_steps.hpp), for tables and legends: its counts,
// and its drawn boxes and marks.
#pragma once

#include <string>
#include <string_view>

#include "core/explain/ball_steps.hpp"

namespace alphascope {

// Name of a count in the list step_count: "balls in its cell", "in conflict". An unknown id is
// returned with blanks for underscores.
std::string step_count_name(std::string_view id);
const char* step_mark_name(StepKind kind, StepMark mark);  // "kept", "valid", "in the cube"
const char* step_box_name(StepKind kind, StepMark mark);   // "cells that the cube meets"

}  // namespace alphascope
