// SPDX-License-Identifier: GPL-3.0-or-later
// Version and commit of the program.
#pragma once

#include <string_view>

namespace alphascope {

std::string_view program_version();  // "0.2.0"
// Short commit id, with "-dirty" for a changed working tree. An archive that git made knows its
// commit. "unknown" in other copies outside a repository.
std::string_view program_commit();

}  // namespace alphascope
