// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of the panels that follow from the session's state. Pure functions: no window, no GL.
#pragma once

#include "app/session/session.hpp"
#include "ui/panels/view_state.hpp"

namespace alphascope {

// Titles of errors that say what is still open.
inline constexpr const char* kNotOpened = "The file cannot be opened";
inline constexpr const char* kNotChanged = "The selection cannot be changed";

// The line for a complex that is computed and not yet on screen. For example "α 3.20 Å²: 1,600,404
// tetrahedra · drawing".
std::string pending_text(const Answer& answer);
// Says that computing was cancelled, and names alpha and solvent radius of the complex on screen.
std::string cancelled_text(const Request& shown);
// The badge of the comparison with CGAL, for the complex on screen.
BadgeInfo describe_agreement(const SessionState& state, const Answer* shown, bool comparing);

}  // namespace alphascope
