// SPDX-License-Identifier: GPL-3.0-or-later
// Shared parts of the sources that register commands, and their functions.
#pragma once

#include <functional>
#include <string>

#include "core/document/commands/commands.hpp"
#include "core/document/reference/atom_set.hpp"
#include "ui/calls.hpp"
#include "ui/panels/view_state.hpp"

namespace alphascope {

struct DisplayField;
struct Measurement;

// Each returns a test for a command that needs a molecule or a result. The test says why the
// command cannot run; empty if it can.
std::function<std::string()> without_molecule(const ViewState& s);
std::function<std::string()> without_result(const ViewState& s);

// The parameter of a command that switches a value, and the action. Without an argument the value
// is toggled.
Parameter on_or_off();
Outcome set_switch(const Arguments& arguments, bool& value);

// A command that switches `value`: a line with a tick in the menu.
CommandSpec with_switch(CommandSpec spec, bool& value);

// Commands of alpha, solvent, molecule, engine, comparison and benchmark.
void add_compute_commands(Commands& commands, ViewState& s, const Calls& ask);

// Commands of recordings, sessions, recent files, the scale and pages. The caller adds each of
// them, since the order decides places in menus.
CommandSpec fetch_command(ViewState& s, const Calls& ask);
CommandSpec open_session_command(ViewState& s, const Calls& ask);
CommandSpec record_command(ViewState& s, const Calls& ask);
CommandSpec save_session_command(ViewState& s, const Calls& ask);
CommandSpec recent_files_command(ViewState& s, const Calls& ask);
CommandSpec scale_command(ViewState& s);
CommandSpec page_command(ViewState& s);
CommandSpec section_command(ViewState& s);
// Commands of the view.
void add_camera_commands(Commands& commands, ViewState& s, const Calls& ask);

// The command of a setting of the display, the commands of all its switches but the projection, and
// those of presets, numbers and colours.
CommandSpec display_command(ViewState& s, const DisplayField& field);
void add_display_switches(Commands& commands, ViewState& s);
void add_look_commands(Commands& commands, ViewState& s);

// Commands of the objects of atoms.
void add_object_commands(Commands& commands, ViewState& s);

// Commands of the clip.
void add_clip_commands(Commands& commands, ViewState& s, const Calls& ask);

// Commands of the selection.
void add_selection_commands(Commands& commands, ViewState& s, const Calls& ask);

// Commands of the page that explains a simplex.
void add_why_commands(Commands& commands, ViewState& s);

// Commands of the page that shows an engine's steps.
void add_steps_commands(Commands& commands, ViewState& s);

// Commands of the sandbox.
void add_sandbox_commands(Commands& commands, ViewState& s, const Calls& ask);

// Commands of lessons.
void add_lesson_commands(Commands& commands, ViewState& s, const Calls& ask);

// Commands that hide and colour atoms.
void add_appearance_commands(Commands& commands, ViewState& s);

// Returns the item of the open context menu or, if no menu is open, the item under the mouse.
// Either may be none.
const std::optional<Ref>& pointed(const ViewState& s);
void add_pointed_commands(Commands& commands, ViewState& s, const Calls& ask);

// Commands of labels, distances and angles.
void add_annotation_commands(Commands& commands, ViewState& s, const Calls& ask);

// The last parameter of commands on atoms, and a function that reads it: named atoms or, without a
// name, the selection. ViewState::references must not be null.
Parameter which_atoms();
struct NamedOrSelectedAtoms {
  AtomSet atoms;
  std::string fault;  // a sentence; empty if there are atoms
};
Outcome add_measurement(ViewState& s, const Measurement& m);
NamedOrSelectedAtoms named_or_selected_atoms(const ViewState& s, const std::string& text);
std::function<std::string()> without_picture(const ViewState& s);
inline constexpr const char* kNoComplexYet = "The complex of this molecule is not ready yet.";

}  // namespace alphascope
