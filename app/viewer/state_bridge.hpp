// From what the session holds to what the panels show, and back. Pure functions: no window, no GL.
#pragma once

#include "app/session/session.hpp"
#include "ui/panels/view_state.hpp"

namespace alphascope {

// "α 3.20 Å²: 1,600,404 tetrahedra · drawing": of what is computed and not yet on screen.
std::string pending_text(const Answer& answer);
// Of the complex on screen.
BadgeInfo describe_agreement(const SessionState& state, const Answer* shown, bool comparing);

}  // namespace alphascope
