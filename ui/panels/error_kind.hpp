// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of errors that the window shows. A script that meets one ends with the exit code of its
// kind.
#pragma once

#include <cstdint>

namespace alphascope {

enum class ErrorKind : std::uint8_t {
  request,    // it cannot be done like this, such as saving over a file that was read
  input,      // a file cannot be read or understood
  computing,  // computing, drawing or memory
  output,     // a file cannot be written
};

}  // namespace alphascope
