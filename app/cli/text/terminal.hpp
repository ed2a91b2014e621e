// SPDX-License-Identifier: GPL-3.0-or-later
// Handles the terminal during long work. Signals cancel the work, one line of standard error shows
// progress, and failed writes to standard output are noticed.
#pragma once

#include "core/run/cancel_token.hpp"

namespace alphascope::cli {

// Call first of all. The first SIGINT (Ctrl-C), SIGTERM or SIGHUP cancels run_context(). If the
// work does not react, the program ends after 2 s. The next signal kills it. Signals ignored at the
// start stay ignored. Temporary files are removed in every case.
void set_up_signals();

// Call before any file is opened. If descriptor 0, 1 or 2 is closed, gives it a file whose use
// fails; otherwise an output file could get that number. From here on std::cout remembers its first
// write error.
void set_up_standard_streams();

// Sends later summaries from std::cout to standard error, since a result takes standard output.
void summary_to_standard_error();

// Flushes std::cout and returns the exit status of the process. It is `status`, unless that is 0
// and standard output lost data, which is an error with a message. If the reader of a pipe closed
// it, the status is 141 without a message, as shells show for SIGPIPE.
int finish_standard_output(int status);

// The amount of output besides results and errors. Quiet: none. Verbose: also progress as lines,
// and for each result its stages, the time for opening and the memory in use.
enum class Verbosity { quiet, normal, verbose };

// Set before other calls. Default: normal.
void set_verbosity(Verbosity verbosity);
Verbosity verbosity();

// Whether results may hold data that depends on time and threads. False with --no-times. Default:
// true.
void set_times_wanted(bool wanted);
bool times_wanted();
// Whether summaries hold times. False with --no-times or when quiet.
bool times_shown();

// The context of the program's work. Progress is shown if standard error is a terminal and the
// program is not quiet. When verbose, each stage is a line of its own, also without a terminal. A
// dumb terminal (TERM=dumb or unset) gets no rewritten line. No terminal gets escape sequences.
const RunContext& run_context();

// The exit status after cancelling, as shells expect: 128 + the signal.
int cancelled_status();

// Removes the progress line. Call before printing other text.
void clear_progress();

}  // namespace alphascope::cli
