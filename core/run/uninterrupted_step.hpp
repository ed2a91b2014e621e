// SPDX-License-Identifier: GPL-3.0-or-later
// Steps that no signal interrupts halfway: a file is made and its name noted for removal, several
// files get their names, or a program is started and its process noted.
#pragma once

#include <csignal>

namespace alphascope {

// Signals wait while an object exists: they are blocked on this thread, and a handler on another
// thread waits in end_uninterrupted_steps(). A step should take milliseconds.
class UninterruptedStep {
 public:
  // Does not return once end_uninterrupted_steps() was called: the process is about to end.
  UninterruptedStep();
  ~UninterruptedStep();
  UninterruptedStep(const UninterruptedStep&) = delete;
  UninterruptedStep& operator=(const UninterruptedStep&) = delete;

 private:
  sigset_t before_;
};

// For a signal handler that ends the program. Afterwards no step can begin, and the steps in
// progress have finished or a second has passed. It makes only calls that are allowed in a handler.
void end_uninterrupted_steps() noexcept;

}  // namespace alphascope
