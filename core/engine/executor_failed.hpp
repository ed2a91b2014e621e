#pragma once

#include <stdexcept>

namespace alphascope {

// A device cannot go on: it is lost, or its driver answers as none should. what() is a sentence
// without its full stop. A device whose memory is short throws std::bad_alloc instead.
struct ExecutorFailed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace alphascope
