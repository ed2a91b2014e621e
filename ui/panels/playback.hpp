// What moves by itself.
#pragma once

namespace alphascope {

struct Playback {
  bool alpha = false;           // one step a finished result
  bool backwards = false;       // alpha falls
  bool models = false;          // models follow one another as frames
  float models_per_second = 5;  // at most; fewer when computing takes longer
};

}  // namespace alphascope
