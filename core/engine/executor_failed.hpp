// SPDX-License-Identifier: GPL-3.0-or-later
// The exception of a device that fails.
#pragma once

#include <stdexcept>

namespace alphascope {

// A device cannot continue: it is lost, or its driver gives an impossible answer. what() is a
// sentence without its full stop. A device with too little memory throws std::bad_alloc instead.
struct ExecutorFailed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace alphascope
