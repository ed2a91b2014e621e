// SPDX-License-Identifier: GPL-3.0-or-later
// Ends both programs cleanly after a signal, a fault, or exhausted memory. No temporary file and no
// incomplete file stays.
#pragma once

#include <initializer_list>

namespace alphascope {

// Call first in main(). Messages begin with `program`. `status` is the exit status if memory is
// exhausted where no exception can pass, such as in a destructor.
void prepare_clean_exit(const char* program, int status);

// Handles a signal, unless it was ignored at the start. For example nohup ignores signals that a
// program has to survive.
void handle_signal(int signal, void (*handler)(int));
// The given signals end the program after its temporary files are removed.
void end_on_signals(std::initializer_list<int> signals);

// For a handler: removes the temporary files, then lets the signal kill the program.
void kill_self_by(int signal);

}  // namespace alphascope
