// SPDX-License-Identifier: GPL-3.0-or-later
// The main function of alphascope-cli, which computes exact alpha complexes without a window.
#include "app/cli/command_line.hpp"
#include "app/cli/text/terminal.hpp"

int main(int argc, char** argv) {
  alphascope::cli::set_up_signals();
  alphascope::cli::set_up_standard_streams();
  return alphascope::cli::finish_standard_output(alphascope::cli::run_command_line(argc, argv));
}
