// A sink for what a filter decides by. A filter calls it with the number whose sign it asks for and
// with the bound on that number's error, in the filter's own precision. Host and device.
#pragma once

#include "core/geometry/host_device.hpp"

namespace alphascope {

// The engines' sink: nothing is recorded, and compilers leave no trace of it.
struct NotRecorded {
  template <class Real>
  ALPHASCOPE_INLINE void operator()(Real, Real) const {}
};

}  // namespace alphascope
