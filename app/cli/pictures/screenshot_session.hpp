// SPDX-License-Identifier: GPL-3.0-or-later
// Opens a session for a picture without a window.
#pragma once

#include "app/cli/input.hpp"
#include "app/cli/pictures/picture_options.hpp"
#include "core/document/session/session_file.hpp"

namespace alphascope::cli {

struct SessionToDraw {
  SessionDocument session;
  Input input;
  std::vector<std::string> notes;  // to be printed; each ends with a full stop
};

// Opens the session with its molecule, or with options.input.file in its place. Throws ReadError if
// the session's molecule has changed since it was saved. A named file that differs is used with a
// note.
SessionToDraw open_session(const ScreenshotCommandOptions& options, const RunContext& context);

}  // namespace alphascope::cli
