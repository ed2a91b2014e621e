// A fault of the program itself: something that must be there is not. Said instead of going on with
// what would be wrong.
#pragma once

#include <stdexcept>
#include <string>

namespace alphascope {

class InternalError : public std::logic_error {
 public:
  // `what`: a sentence about what is missing, with its full stop.
  explicit InternalError(const std::string& what)
      : std::logic_error("internal error: " + what +
                         " This is a fault of the program: please report it with your input.") {}
};

}  // namespace alphascope
