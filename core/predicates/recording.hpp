// SPDX-License-Identifier: GPL-3.0-or-later
// Sinks, which receive the steps of an engine's own code so that they can be shown. A filter calls
// its sink with the number whose sign it needs, and with the bound on that number's error, in the
// filter's precision. Other code documents beside the call what it passes. Host and device.
#pragma once

#include "core/geometry/host_device.hpp"

namespace alphascope {

// The sink of a normal run: it records nothing, and compilers remove the calls.
struct NoSink {
  template <class... Seen>
  ALPHASCOPE_INLINE void operator()(const Seen&...) const {}
};

}  // namespace alphascope
