// SPDX-License-Identifier: GPL-3.0-or-later
// The names of temporary files beside outputs, and the removal of those that killed processes left
// behind.
#pragma once

#include <filesystem>

namespace alphascope {

// A short name in the folder of `target`; the name of `target` itself may have the greatest
// possible length.
std::filesystem::path temporary_name(const std::filesystem::path& target, int attempt);

// Marks a file as in use, so that no process removes it as left behind. The mark lasts until the
// descriptor is closed.
void mark_as_in_use(int descriptor);

// Removes the temporary files in this folder whose processes have ended; once for each folder.
// Files that another computer or container writes there are marked as in use, and stay.
void remove_left_behind(const std::filesystem::path& folder);

}  // namespace alphascope
