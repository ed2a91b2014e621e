// SPDX-License-Identifier: GPL-3.0-or-later
// An exception for faults of the program itself: something that must exist is missing. It is thrown
// instead of continuing with a wrong result.
#pragma once

#include <stdexcept>
#include <string>

namespace alphascope {

class InternalError : public std::logic_error {
 public:
  // `what` is a sentence about the missing thing, with its full stop.
  explicit InternalError(const std::string& what)
      : std::logic_error("internal error: " + what +
                         " This is a fault of the program: please report it with your input.") {}
};

}  // namespace alphascope
