// SPDX-License-Identifier: GPL-3.0-or-later
// The name of the program, as files that it writes state it.
#pragma once

#include <string>

namespace alphascope {

// The program that computed the results: "alphascope", "0.2.0", "0123456789ab".
struct ProgramName {
  std::string name, version, commit;
  std::string text() const { return name + " " + version + " (" + commit + ")"; }
};

}  // namespace alphascope
