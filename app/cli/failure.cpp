#include "app/cli/failure.hpp"

#include <iostream>
#include <new>
#include <stdexcept>

#include "app/cli/terminal.hpp"
#include "core/io/atomic_file.hpp"
#include "core/molecule/printable.hpp"

namespace alphascope::cli {

Failure current_failure() {
  try {
    throw;
  } catch (const Cancelled&) {
    return {ExitCode::cancelled, "cancelled; nothing was written.", false};
  } catch (const UsageError& e) {
    return {ExitCode::usage, e.what(), true};
  } catch (const ReadError& e) {
    return {ExitCode::unreadable_input, e.what(), true};
  } catch (const WriteError& e) {
    return {ExitCode::unwritable_output, e.what(), false};
  } catch (const EngineUnavailable& e) {
    return {ExitCode::computing_failed, e.what(), false};
  } catch (const std::invalid_argument& e) {
    return {ExitCode::usage, e.what(), true};
  } catch (const std::bad_alloc&) {
    return {ExitCode::computing_failed,
            "Not enough memory. Use a smaller alpha or solvent radius, or --tetrahedra-only.",
            true};
  } catch (const std::exception& e) {
    return {ExitCode::computing_failed, e.what(), true};
  }
}

void print_error(const std::string& message) {
  clear_progress();
  std::cout.flush();
  std::cerr << "alphascope-cli: " << printable(message) << std::endl;
}

}  // namespace alphascope::cli
