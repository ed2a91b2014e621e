// SPDX-License-Identifier: GPL-3.0-or-later
// Maps exceptions to messages and exit codes.
#include "app/cli/failure.hpp"

#include <iostream>
#include <new>
#include <stdexcept>

#include "app/cli/text/terminal.hpp"
#include "app/session/engines.hpp"
#include "core/document/store/evaluator.hpp"
#include "core/files/atomic_file.hpp"
#include "core/files/read_error.hpp"
#include "core/radii/amber_radii.hpp"
#include "core/text/printable.hpp"

namespace alphascope::cli {
namespace {

constexpr const char* kForAnyCommand = "Close other programs.";
std::string memory_remedy = kForAnyCommand;

}  // namespace

void set_memory_remedy(const OptionCommand& command) {
  const auto has = [&](const char* name) {
    for (const Option& option : command.options) {
      if (option.shown_name() == name) return true;
    }
    return false;
  };
  std::string text;
  const auto add = [&](bool can, const char* words) {
    if (can) text += (text.empty() ? "" : ", or ") + std::string(words);
  };
  const bool alpha = has("--alpha"), solvent = has("--solvent");
  add(alpha || solvent, alpha && solvent ? "Use a smaller alpha or solvent radius"
                        : alpha          ? "Use a smaller alpha"
                                         : "Use a smaller solvent radius");
  add(has("--tetrahedra-only"), "add --tetrahedra-only");
  add(has("--select"),
      text.empty() ? "Keep fewer atoms with --select" : "keep fewer atoms with --select");
  memory_remedy = text.empty() ? kForAnyCommand : text + ".";
}

Failure current_failure() {
  try {
    throw;
  } catch (const Cancelled&) {
    return {ExitCode::cancelled, "cancelled; nothing was written.", false};
  } catch (const UsageError& e) {
    return {ExitCode::usage, e.what(), true};
  } catch (const ReadError& e) {
    return {ExitCode::unreadable_input, e.what(), true};
  } catch (const ReplacesInput& e) {
    return {ExitCode::usage, e.what(), false};
  } catch (const WriteError& e) {
    return {ExitCode::unwritable_output, e.what(), false};
  } catch (const EngineUnavailable& e) {
    return {ExitCode::computing_failed, e.what(), false};
  } catch (const std::invalid_argument& e) {
    return {ExitCode::usage, e.what(), true};
  } catch (const NoRoom& e) {
    return {ExitCode::computing_failed, std::string(e.what()) + " " + memory_remedy, true};
  } catch (const std::bad_alloc&) {
    return {ExitCode::computing_failed, "Not enough memory. " + memory_remedy, true};
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
