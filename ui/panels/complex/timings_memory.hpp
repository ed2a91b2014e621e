// The page of timings: which run of the engines it shows.
#pragma once

#include <string>

namespace alphascope {

struct TimingsMemory {
  std::string molecule;  // SHA-256 of its file
  bool cold = true;      // the first run of the molecule, set-up included
  bool pinned = false;   // the user has chosen which
};

}  // namespace alphascope
