// Temporary files beside outputs: their names, and what to do about those of processes that were
// killed.
#pragma once

#include <filesystem>

namespace alphascope {

// In the folder of `target`, and short, since the name of `target` may be as long as can be.
std::filesystem::path temporary_name(const std::filesystem::path& target, int attempt);

// So that nobody takes a file for one left behind: kept until the descriptor is closed.
void mark_as_in_use(int descriptor);

// Removes the temporary files in this folder of processes that are no more; once for each folder.
// What another computer or container writes there is in use, and stays.
void remove_left_behind(const std::filesystem::path& folder);

}  // namespace alphascope
