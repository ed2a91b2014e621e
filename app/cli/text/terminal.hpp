// The terminal's side of long work: signals cancel, progress shows on one line of standard error,
// and what standard output loses is noticed.
#pragma once

#include "core/run/cancel_token.hpp"

namespace alphascope::cli {

// First of all. The first SIGINT (Ctrl-C), SIGTERM or SIGHUP cancels run_context(), and where the
// work does not notice, the program ends 2 s later; the next signal kills it. A signal that was
// ignored at the start stays so. Whatever signal kills it, no temporary file stays.
void set_up_signals();

// Before a file is opened: gives descriptors 0, 1 and 2 that are closed something
// that only fails, so that no file becomes standard output; from here on std::cout remembers the
// first error of writing.
void set_up_standard_streams();

// Summaries written to std::cout go to standard error from here on: a result takes standard output.
void summary_to_standard_error();

// Writes out std::cout. Returns the exit status of a process whose work ended with `status`: 0
// becomes another one, with a message, when standard output lost something. A pipe that was closed
// at its other end gives no message and 141, which is what the shell shows for SIGPIPE.
int finish_standard_output(int status);

// How much is said besides results and errors. quiet: nothing. verbose: also progress as lines, and
// with each result its stages, the time for opening and the memory used.
enum class Verbosity { quiet, normal, verbose };

// How much is said; to be set before the rest is called. Normal unless set.
void set_verbosity(Verbosity verbosity);
Verbosity verbosity();

// Whether results may hold what depends on time and threads: not with --no-times. True unless set.
void set_times_wanted(bool wanted);
bool times_wanted();
// Whether summaries have times: neither then nor when quiet.
bool times_shown();

// The context for the program's one piece of work. Progress shows when standard error is a
// terminal, unless the program is to be quiet; when it is to be verbose, each stage is a line
// instead, terminal or not. A dumb terminal (TERM=dumb, or no TERM) gets no line that changes; no
// terminal ever gets escape sequences.
const RunContext& run_context();

// 128 + the signal that cancelled the work: the exit status that shells expect.
int cancelled_status();

// Removes the progress line, before other text is printed.
void clear_progress();

}  // namespace alphascope::cli
