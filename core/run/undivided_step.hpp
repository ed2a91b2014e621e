// Steps that no signal divides: a file that is made is also known to those who remove it, files
// that belong together get their names together, a program that is started is also known.
#pragma once

#include <csignal>

namespace alphascope {

// While one is there, signals wait: on this thread they are blocked, and a handler on another
// thread waits for its end in end_of_steps(). For steps of milliseconds.
class UndividedStep {
 public:
  // Does not return once end_of_steps() was called: the process is about to end.
  UndividedStep();
  ~UndividedStep();
  UndividedStep(const UndividedStep&) = delete;
  UndividedStep& operator=(const UndividedStep&) = delete;

 private:
  sigset_t before_;
};

// For a signal handler that ends the program: no step begins any more, and those under way are
// finished, or a second has passed. Calls only what is allowed there.
void end_of_steps() noexcept;

}  // namespace alphascope
