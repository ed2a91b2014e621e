// SPDX-License-Identifier: GPL-3.0-or-later
// The settings of the display as one table. A row says all about a setting but its effect on the
// picture, which display_style.hpp has. Panel, commands, session files, command line, Undo and the
// docs come from the table.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <variant>

#include "core/document/commands/number_input.hpp"
#include "core/document/settings/display.hpp"

namespace alphascope {

enum class DisplayGroup : std::uint8_t { balls, complex, cavities, light, projection };

// An option of the command line that draws. `name` is empty where there is none.
struct DisplayOption {
  const char* name = "";
  const char* text = "";  // empty: the help of the setting
  bool sets = true;       // the value that the option of a switch sets
};

struct DisplayField {
  using Member = std::variant<bool DisplaySettings::*, float DisplaySettings::*,
                              int DisplaySettings::*, Paint DisplaySettings::*>;
  const char* id;   // end of the names of its controls: "edge_thickness"
  const char* key;  // in session files: "edge_thickness_angstrom"
  Member member;
  DisplayGroup group;
  const char* title;  // of the command and in Undo: "Thickness of edges"
  const char* label;  // beside its control, among those of its group: "Thickness"
  const char* help;   // a sentence or a noun phrase without full stop
  const char* command;
  DisplayOption option = {};
  NumberRule rule = {"", 0, 0};              // of a number
  double step = 0;                           // of the slider
  double slider_most = 0;                    // the slider's end if it is below that of the rule
  bool percent = false;                      // the control shows a share in percent
  PaintTarget painted = PaintTarget::balls;  // of a paint
  bool kept_by_presets = false;              // presets leave it as it is
  bool needs_whole_complex = false;          // has no effect with “Tetrahedra only”
  const char* menu = "";                     // of a switch
  bool line_above = false;                   // in the menu
  const char* shortcut = "";                 // of a switch: "B"
  const char* synonyms = "";                 // more words to find the command by
  const char* former_key = "";               // in session files of older versions
};

// In the order of session files.
std::span<const DisplayField> display_fields();

// The row of this member. Throws std::logic_error if there is none.
const DisplayField& display_field(DisplayField::Member member);

bool is_switch(const DisplayField& field);
bool is_number(const DisplayField& field);
bool is_paint(const DisplayField& field);

// The value of a number, or 0 and 1 of a switch. A paint has none: std::logic_error.
double number_of(const DisplayField& field, const DisplaySettings& display);
void set_number(const DisplayField& field, DisplaySettings& display, double value);
// The value as it is typed: "0.3", "on", "chain".
std::string value_text(const DisplayField& field, const DisplaySettings& display);
// The bounds of a number, in the unit of its rule: "0.02 to 1".
std::string range_text(const DisplayField& field);
// The name of the setting in a sentence: "thickness of edges".
std::string name_of(const DisplayField& field);

// Makes the values of these settings those of `from`.
void copy_group(DisplayGroup group, const DisplaySettings& from, DisplaySettings& to);

// The kinds of atoms that can be drawn beside the body.
struct BesideKind {
  const char* id;  // in session files and on the command line
  const char* title;
  bool AtomsBesideBody::*member;
};
inline constexpr BesideKind kBesideKinds[] = {
    {"ligands", "Ligands", &AtomsBesideBody::ligands},
    {"ions", "Ions", &AtomsBesideBody::ions},
    {"waters", "Waters", &AtomsBesideBody::waters},
    {"hydrogens", "Hydrogens", &AtomsBesideBody::hydrogens}};
std::string command_of(const BesideKind& kind);  // "view.left_out_ligands"

// The name of the one setting that differs, "display" for several; empty: none differs.
std::string difference_of(const DisplaySettings& a, const DisplaySettings& b);

}  // namespace alphascope
