// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a session and opens its molecule.
#include "app/cli/pictures/screenshot_session.hpp"

#include <stdexcept>

#include "app/cli/input.hpp"
#include "core/files/file_hash.hpp"
#include "core/files/read_error.hpp"
#include "core/selection/selection_expression.hpp"

namespace alphascope::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOtherMolecule =
    "Name the molecule that the session was saved with, or change the session in the window";

std::string without_stop(std::string sentence) {
  if (sentence.ends_with('.')) sentence.pop_back();
  return sentence;
}

fs::path same_file(const fs::path& session, const FileReference& wanted, const char* what,
                   const char* remedy, const RunContext& context) {
  const FoundFile found = find_file(wanted, session.parent_path(), context);
  if (found.state == FoundFile::State::same) return found.path;
  throw ReadError(session, 0, what + without_stop(why_not_found(wanted, found)), remedy);
}

}  // namespace

SessionToDraw open_session(const ScreenshotCommandOptions& options, const RunContext& context) {
  const fs::path file = fs::absolute(options.session).lexically_normal();
  ReadSession read = read_session(file, context);
  SessionToDraw drawn{std::move(read.session), {}, std::move(read.notes)};
  SessionDocument& s = drawn.session;
  fs::path molecule = options.input.file;
  if (molecule.empty()) {
    molecule = same_file(file, s.molecule, "its molecule: ",
                         "Put the file back, or name its new place as FILE after --session S.json",
                         context);
  } else if (molecule = local_file(molecule, options.input, context);
             hash_of_file(molecule, context) != s.molecule.sha256) {
    drawn.notes.push_back(molecule.string() +
                          " differs from the file of the saved session: it has another SHA-256.");
  }
  OpenOptions open = s.settings.open;
  if (!s.radii_table.empty()) {
    open.radii_table =
        same_file(file, s.radii_table, "its table of radii: ", "Put it back", context);
  }
  drawn.input.open_milliseconds = 0;
  drawn.input.balls = open.balls;
  try {
    drawn.input.opened = open_molecule(molecule, open, context);
  } catch (const SelectionError& error) {
    throw ReadError(file, 0,
                    std::string("\"open.selection\" does not fit the molecule, ") + error.what(),
                    kOtherMolecule);
  } catch (const std::invalid_argument& error) {
    throw ReadError(
        file, 0, "the options in \"open\" do not fit the molecule: " + without_stop(error.what()),
        kOtherMolecule);
  }
  return drawn;
}

}  // namespace alphascope::cli
