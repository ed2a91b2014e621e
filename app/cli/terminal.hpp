// The terminal's side of long work: Ctrl-C cancels, progress shows on one line of standard error.
#pragma once

#include "core/run/cancel_token.hpp"

namespace alphascope::cli {

// The context for the program's one piece of work. The first Ctrl-C (or SIGTERM) cancels it, the
// next kills the program. Progress is shown only when standard error is a terminal.
const RunContext& run_context();

// Removes the progress line, before other text is printed.
void clear_progress();

}  // namespace alphascope::cli
