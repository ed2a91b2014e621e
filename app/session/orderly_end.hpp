// How both programs end when something else ends them: a signal, an error of the program, memory
// that is used up. No temporary file stays, and no half file.
#pragma once

#include <initializer_list>

namespace alphascope {

// First of all in main(). `program` begins messages; `status` is the exit status where memory is
// used up at a place that cannot say so, as in the end of an object.
void prepare_orderly_end(const char* program, int status);

// Handles a signal, unless it was ignored at the start: nohup and shells ignore those that a
// program is to outlive.
void handle_signal(int signal, void (*handler)(int));
// These end the program, after its temporary files.
void end_on_signals(std::initializer_list<int> signals);

// For a handler: removes the temporary files, then the signal kills the program.
void die_of(int signal);

}  // namespace alphascope
