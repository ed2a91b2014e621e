// Sinks: what an engine's own code tells whoever wants to show how it decides. A filter calls its
// sink with the number whose sign it asks for and with the bound on that number's error, in the
// filter's own precision; other code says beside the call what it hands over. Host and device.
#pragma once

#include "core/geometry/host_device.hpp"

namespace alphascope {

// The engines' sink: nothing is recorded, and compilers leave no trace of it.
struct NotRecorded {
  template <class... Seen>
  ALPHASCOPE_INLINE void operator()(const Seen&...) const {}
};

}  // namespace alphascope
