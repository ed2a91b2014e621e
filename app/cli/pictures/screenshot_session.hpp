// What a session says, for a picture of it without a window.
#pragma once

#include "app/cli/input.hpp"
#include "app/cli/pictures/picture_options.hpp"
#include "core/document/session/session_file.hpp"

namespace alphascope::cli {

struct SessionToDraw {
  SessionDocument session;
  Input input;
  std::vector<std::string> notes;  // to be told; no full stop is missing
};

// The session of `options.session`, with its molecule, or with options.input.file in its place.
// Throws ReadError where that is not the one that was saved with; a file that is named is used
// whatever it is, with a note.
SessionToDraw open_session(const ScreenshotCommandOptions& options, const RunContext& context);

}  // namespace alphascope::cli
