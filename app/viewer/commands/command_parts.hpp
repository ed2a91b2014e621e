// What the sources that register commands share.
#pragma once

#include <functional>
#include <string>

#include "core/document/commands/commands.hpp"
#include "ui/calls.hpp"
#include "ui/panels/view_state.hpp"

namespace alphascope {

// Why a command cannot run without these; empty: it can.
std::function<std::string()> without_molecule(const ViewState& s);
std::function<std::string()> without_result(const ViewState& s);

// The parameter of a command that switches something, and what it makes of the value: without
// argument it is turned over.
Parameter on_or_off();
Outcome set_switch(const Arguments& arguments, bool& value);

// Something that is on or off: a line with a tick in the menu.
CommandSpec with_switch(CommandSpec spec, bool& value);

// Alpha, solvent, molecule, engine, comparison, benchmark.
void add_compute_commands(Commands& commands, ViewState& s, const Calls& ask);

// Of recordings, sessions, recent files, the scale and pages; each is added where its menu has it.
CommandSpec open_session_command(ViewState& s, const Calls& ask);
CommandSpec record_command(ViewState& s, const Calls& ask);
CommandSpec save_session_command(ViewState& s, const Calls& ask);
CommandSpec recent_files_command(ViewState& s, const Calls& ask);
CommandSpec scale_command(ViewState& s);
CommandSpec page_command(ViewState& s);
CommandSpec section_command(ViewState& s);
// How the picture is looked at.
void add_camera_commands(Commands& commands, ViewState& s, const Calls& ask);

// Presets, light and lines.
void add_look_commands(Commands& commands, ViewState& s);

// What balls and simplices are coloured by.
void add_paint_commands(Commands& commands, ViewState& s);

// The clip.
void add_clip_commands(Commands& commands, ViewState& s, const Calls& ask);

// What is selected in the picture.
void add_selection_commands(Commands& commands, ViewState& s, const Calls& ask);

// The page that explains a simplex.
void add_why_commands(Commands& commands, ViewState& s);

// The page of an engine's steps.
void add_steps_commands(Commands& commands, ViewState& s);

// Balls set by hand.
void add_sandbox_commands(Commands& commands, ViewState& s, const Calls& ask);

// Lessons.
void add_lesson_commands(Commands& commands, ViewState& s, const Calls& ask);

// What the picture shows of atoms.
void add_appearance_commands(Commands& commands, ViewState& s);

// What is under the mouse, or what the open menu of the right button is about; none: nothing.
const std::optional<Ref>& pointed(const ViewState& s);
void add_pointed_commands(Commands& commands, ViewState& s, const Calls& ask);

// Labels, distances and angles.
void add_annotation_commands(Commands& commands, ViewState& s, const Calls& ask);

// The last parameter of commands on atoms, and what it asks for: atoms that are named or, where it
// is left out, what is selected. ViewState::references must be known.
Parameter which_atoms();
struct AskedAtoms {
  AtomSet atoms;
  std::string fault;  // a sentence; empty: there are some
};
Outcome add_measurement(ViewState& s, const Measurement& m);
AskedAtoms asked_atoms(const ViewState& s, const std::string& text);
std::function<std::string()> without_picture(const ViewState& s);
inline constexpr const char* kNoComplexYet = "The complex of this molecule is not there yet.";

}  // namespace alphascope
