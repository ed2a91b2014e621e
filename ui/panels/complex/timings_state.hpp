// SPDX-License-Identifier: GPL-3.0-or-later
// The state of the page of timings between frames: the run that it shows.
#pragma once

#include <string>

namespace alphascope {

struct TimingsState {
  std::string molecule;  // SHA-256 of the molecule's file
  bool cold = true;      // shows the first run of the molecule, with its set-up
  bool pinned = false;   // the user has chosen the run
};

}  // namespace alphascope
