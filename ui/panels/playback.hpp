// SPDX-License-Identifier: GPL-3.0-or-later
// Settings of playback: alpha and models that change by themselves.
#pragma once

namespace alphascope {

struct Playback {
  bool alpha = false;           // one step for each finished result
  bool backwards = false;       // alpha falls
  bool models = false;          // models follow one another like frames
  float models_per_second = 5;  // at most; fewer if computing takes longer
};

}  // namespace alphascope
