// alphascope-cli: the exact alpha complex of a molecule, without a window.
#include "app/cli/command_line.hpp"

int main(int argc, char** argv) {
  return alphascope::cli::run_command_line(argc, argv);
}
