// SPDX-License-Identifier: GPL-3.0-or-later
// Small building blocks that the panels share. They record where each named widget is, so that
// scripts and tests find it.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <initializer_list>
#include <string>

#include "ui/widgets/key_state.hpp"
#include "ui/widgets/widget_rects.hpp"

namespace alphascope {

class Commands;
class PanelSet;
class Store;
enum class BrowserPurpose : std::uint8_t;
struct Calls;
struct Colour;
struct Inputs;
struct NumberRule;
struct Palette;
struct PanelFonts;
struct ViewState;

struct PanelContext {
  ViewState& state;
  WidgetRects& rects;
  const Commands& commands;
  Store& store;          // makes derived results; it must be asked in each frame
  const Inputs& inputs;  // the present inputs of derived results
  const Calls& calls;    // calls to the program, carried out after this frame
  PanelSet& panels;
  const PanelFonts& fonts;
  const Palette& palette;
  float scale = 1;
  std::size_t dialog = 0;  // the dialog being drawn, an index into DialogState::open
  std::size_t level = 0;   // 0: the window is being drawn; n: the nth dialog

  float px(float pixels_at_scale_1) const { return pixels_at_scale_1 * scale; }
};

ImVec4 to_imgui(const Colour& colour, float alpha = 1.0f);
ImU32 to_u32(const Colour& colour, float alpha = 1.0f);

// Records the place of the last item under this name.
void record(PanelContext& ctx, const char* name);

enum class ButtonKind : std::uint8_t { normal, primary, quiet };
bool button(PanelContext& ctx, const char* name, const char* label, ImVec2 size = {0, 0},
            ButtonKind kind = ButtonKind::normal);
// Returns the width in pixels of a button or check box that fits its label.
float button_width(const char* label);
float checkbox_width(const char* label);
// Keeps the next item, `width` pixels wide, in the same line if it fits there after `gap` pixels.
void same_line_where_it_fits(float width, float gap);

bool checkbox(PanelContext& ctx, const char* name, const char* label, bool& value);

// A field for one line of text, as wide as the next item. It shows `hint` while it is empty.
// Returns whether Enter was pressed in it.
bool text_field(PanelContext& ctx, const char* name, std::string& text, const char* hint = "",
                KeyStop kind = KeyStop::type);

// A field that shows the chosen entry and opens a list of all entries. If it returns true, the list
// is open. The caller then draws the entries and calls ImGui::EndCombo().
bool list_field(PanelContext& ctx, const char* name, const char* chosen, ImGuiComboFlags flags = 0);

// Opens the file dialog for this purpose; by default for a molecule.
void open_browser(ViewState& state, BrowserPurpose purpose = {});

// Two or more choices side by side. Returns whether the choice changed.
bool choice(PanelContext& ctx, const char* name, std::initializer_list<const char*> labels,
            int& chosen, float width);

// Draws a label at the left. The next item starts at a column common to all rows.
// It takes the remaining width less `reserve` pixels at scale 1.
void row_label(PanelContext& ctx, const char* label, float reserve = 0);

// A slider with its value as `text` at its right. It takes the remaining width less `reserve`
// pixels at scale 1. Ctrl+click lets the user type a value, which must follow the rule.
bool value_slider(PanelContext& ctx, const char* name, double& value, double low, double high,
                  const NumberRule& rule, const std::string& text, float reserve = 0);

// A slider for values from 0 to 1, shown in percent.
bool percent_slider(PanelContext& ctx, const char* name, float& value, float low, float high);

// A line that opens a list below it. If the list is open, the caller ends it with ImGui::TreePop().
bool disclosure(PanelContext& ctx, const char* name, const std::string& title,
                const Colour& colour);

// Draws a line instead of a disclosure() that has nothing to list. The line is as high, so the
// things below do not move.
void nothing_to_disclose(PanelContext& ctx, const char* text);

// Keeps room for `lines` lines from the cursor position `top` on, even if fewer were drawn.
void reserve_lines(float top, int lines);

// Closes the open popup, menu or list on Escape. To be called between BeginPopup, BeginMenu or
// BeginCombo and their end.
void close_on_escape();

bool section(PanelContext& ctx, const char* name, const char* title);

// Explains the last item, once the mouse has rested on it.
void tooltip(PanelContext& ctx, const char* text);
void muted_text(PanelContext& ctx, const std::string& text);  // one line
void muted_wrapped(PanelContext& ctx, const std::string& text);
void strong_text(PanelContext& ctx, const std::string& text);

// Breaks the text into lines of at most `width` pixels. Lines break at blanks only, never inside
// "1,224 atoms". So a word wider than `width` makes a line of its own.
std::string broken_lines(const std::string& text, float width);
void wrapped_text(const std::string& text);  // in the remaining width

// Returns `text` cut to `width` pixels, with "…" in the middle if it does not fit.
std::string fitted_text(const std::string& text, float width);

}  // namespace alphascope
