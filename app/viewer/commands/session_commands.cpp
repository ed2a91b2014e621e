// SPDX-License-Identifier: GPL-3.0-or-later
// Commands of sessions and recent files, and of the scale of fonts and controls.
#include <algorithm>
#include <filesystem>

#include "app/viewer/commands/command_parts.hpp"
#include "core/document/fetch/fetch.hpp"
#include "core/files/output_ending.hpp"
#include "core/geometry/shortest_number.hpp"
#include "core/text/as_sentence.hpp"
#include "core/text/printable.hpp"
#include "ui/panels/dialogs/browser_state.hpp"
#include "ui/panels/dialogs/dialog_state.hpp"
#include "ui/panels/dialogs/fetch_state.hpp"
#include "ui/panels/dialogs/fields/typed_id.hpp"
#include "ui/panels/dialogs/fields/typed_path.hpp"
#include "ui/panels/window_settings.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;
using Kind = Parameter::Kind;

constexpr const char* kClear = "clear";

Outcome open_session(const Arguments& arguments, ViewState& s, const Calls& ask) {
  if (!arguments.has("path")) {
    open_browser(s, BrowserPurpose::session);
    return {};
  }
  const fs::path path = arguments.text("path");
  std::error_code ignored;
  if (!fs::exists(path, ignored)) {
    return Outcome::refused("There is no file " + printable(path.string()) + ".");
  }
  ask.files.open_session(path);
  return {};
}

Outcome save_session(const Arguments& arguments, ViewState& s, const Calls& ask) {
  if (arguments.has("path")) {
    const fs::path path = path_to_save(arguments.text("path"), kSessionEnding);
    const std::string fault = fault_of_ending(path, {kSessionEnding});
    if (!fault.empty()) return Outcome::refused(as_sentence(fault));
    ask.files.save_session(path);
    return {};
  }
  s.dialogs.session_path = s.session_file.string();  // the session of the open molecule
  s.dialogs.show_save_session = true;
  return {};
}

Outcome fetch(const Arguments& arguments, ViewState& s, const Calls& ask) {
  if (!arguments.has("id")) {
    s.fetch.show = true;
    return {};
  }
  const TypedId typed = read_typed_id(arguments.text("id"), s.fetch.options);
  if (!typed.id) {
    return Outcome::refused(typed.fault.empty() ? "An id is needed." : typed.fault);
  }
  ask.files.fetch(*typed.id, arguments.has("again"));
  return {};
}

std::vector<Choice> recent(const ViewState& s) {
  std::vector<Choice> choices;
  for (const fs::path& file : s.recent) {
    if (const auto id = id_of_fetched(file)) {
      choices.push_back({file.string(), id->text(), "fetched"});
      continue;
    }
    choices.push_back({file.string(), printable(file.filename().string()),
                       printable(file.parent_path().string())});
  }
  if (!choices.empty()) choices.push_back({kClear, "Clear this list"});
  return choices;
}

Outcome open_recent(const Arguments& arguments, const Calls& ask) {
  const std::string chosen = arguments.text("file");
  if (chosen == kClear) {
    ask.files.forget_recent();
    return {};
  }
  std::error_code ignored;
  if (!fs::exists(chosen, ignored)) {
    if (const auto id = id_of_fetched(chosen)) {
      ask.files.fetch(*id, false);
      return {};
    }
    return Outcome::failed("There is no file " + printable(chosen) +
                           ". Find it with “Open molecule…”.");
  }
  ask.files.open(chosen);
  return {};
}

std::vector<Choice> scales(const ViewState& s) {
  std::vector<Choice> choices{
      {"auto", "The scale that the display reports", "", s.window.control_scale == 0}};
  for (const double scale : {1.0, 1.25, 1.5, 1.75, 2.0, 2.5, 3.0}) {
    choices.push_back({shortest_number(scale), shortest_number(100 * scale) + " %", "",
                       s.window.control_scale == scale});
  }
  return choices;
}

}  // namespace

CommandSpec open_session_command(ViewState& s, const Calls& ask) {
  return {.id = "file.open_session",
          .title = "Open session…",
          .help = "Opens a molecule with the settings, the view and the panels that were saved",
          .shortcuts = {{"Ctrl+Shift+O"}},
          .menu = "File",
          .parameters = {{.name = "path",
                          .kind = Kind::path,
                          .help = "The session; if left out, a dialog opens",
                          .optional = true}},
          .run = [&s, ask](const Arguments& arguments) { return open_session(arguments, s, ask); }};
}

CommandSpec fetch_command(ViewState& s, const Calls& ask) {
  return {.id = "file.fetch",
          .title = "Fetch by id…",
          .help = "Fetches an entry of the PDB or a model of AlphaFold DB, and opens it",
          .synonyms = {{"download RCSB UniProt"}},
          .shortcuts = {{"Ctrl+Shift+F"}},
          .menu = "File",
          .parameters = {{.name = "id",
                          .kind = Kind::text,
                          .help = "The id; if left out, a dialog opens",
                          .example = "pdb:1CRN",
                          .optional = true},
                         {.name = "again",
                          .kind = Kind::flag,
                          .help = "Even if its file was fetched before"}},
          .run = [&s, ask](const Arguments& arguments) { return fetch(arguments, s, ask); }};
}

CommandSpec save_session_command(ViewState& s, const Calls& ask) {
  return {.id = "file.save_session",
          .title = "Save session…",
          .help = "Writes the name of the molecule, all settings, the view and the panels",
          .shortcuts = {{"Ctrl+Shift+S"}},
          .menu = "File",
          .line_above = true,
          .parameters = {{.name = "path",
                          .kind = Kind::path,
                          .help = "The JSON file; if left out, a dialog opens",
                          .optional = true}},
          .why_not = without_molecule(s),
          .run = [&s, ask](const Arguments& arguments) { return save_session(arguments, s, ask); }};
}

CommandSpec recent_files_command(ViewState& s, const Calls& ask) {
  return {.id = "file.recent",
          .title = "Recent files",
          .help = "Opens a molecule or session again, or clears the list of them",
          .menu = "File",
          .parameters = {{.name = "file",
                          .kind = Kind::choice,
                          .help = "The file; clear empties the list",
                          .choices = [&s] { return recent(s); }}},
          .run = [ask](const Arguments& arguments) { return open_recent(arguments, ask); }};
}

CommandSpec scale_command(ViewState& s) {
  return {.id = "view.scale",
          .title = "Interface scale",
          .help = "Sets the size of fonts and controls",
          .menu = "View",
          .parameters = {{.name = "scale",
                          .kind = Kind::choice,
                          .help = "1 is 100 %; auto: scale of the display",
                          .choices = [&s] { return scales(s); }}},
          .run = [&s](const Arguments& arguments) {
            const std::string chosen = arguments.text("scale");
            s.window.control_scale = chosen == "auto" ? 0 : std::stod(chosen);
            return Outcome();
          }};
}

}  // namespace alphascope
