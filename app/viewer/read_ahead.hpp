// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the file that the program was started with while the window is being made. Both take about
// as long, so the first picture comes earlier.
#pragma once

#include <filesystem>

#include "app/session/session.hpp"

namespace alphascope {

// Begins to read `path` on a thread of its own, and returns a function that opens molecules. Its
// first call for this path takes the result over, if the options are the usual ones. All other
// calls are `open`. A large file is not read ahead, since only `open` reports progress.
Session::Opener read_ahead(const std::filesystem::path& path, Session::Opener open);

}  // namespace alphascope
