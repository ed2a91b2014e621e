// Small building blocks shared by the panels, and the record of where each named widget is, by
// which scripts and tests find them.
#pragma once

#include <imgui.h>

#include <string>

#include "core/document/commands/commands.hpp"
#include "ui/calls.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/style.hpp"
#include "ui/widgets/widget_rects.hpp"

namespace alphascope {

class PanelSet;
class Store;
struct Inputs;
struct NumberRule;

struct PanelContext {
  ViewState& state;
  WidgetRects& rects;
  const Commands& commands;
  Store& store;          // of derived results: ask it in each frame
  const Inputs& inputs;  // what they are made of now
  const Calls& calls;    // what the program is asked to do, after this frame
  PanelSet& panels;
  const PanelFonts& fonts;
  const Palette& palette;
  float scale = 1;
  std::size_t dialog = 0;  // that is being drawn: index into PanelMemory::dialogs
  std::size_t level = 0;   // 0: the window is being drawn; n: the nth dialog

  float px(float pixels_at_scale_1) const { return pixels_at_scale_1 * scale; }
};

ImVec4 to_imgui(const Colour& colour, float alpha = 1.0f);
ImU32 to_u32(const Colour& colour, float alpha = 1.0f);

// Remembers where the last item is.
void record(PanelContext& ctx, const char* name);

enum class ButtonKind : std::uint8_t { normal, primary, quiet };
bool button(PanelContext& ctx, const char* name, const char* label, ImVec2 size = {0, 0},
            ButtonKind kind = ButtonKind::normal);
// Of a button that is as wide as its label needs, pixels.
float button_width(const char* label);
// The next item, so wide (pixels), stays in the line when it has room there behind a gap.
void same_line_where_it_fits(float width, float gap);

bool checkbox(PanelContext& ctx, const char* name, const char* label, bool& value);

// A line of text as wide as the next item; `hint` shows while it is empty. True: Enter was pressed
// in it.
bool text_field(PanelContext& ctx, const char* name, std::string& text, const char* hint = "",
                KeyStop kind = KeyStop::type);

// What is chosen, which opens a list of what may be. True: it is open; the caller draws its entries
// and ends it with ImGui::EndCombo().
bool list_field(PanelContext& ctx, const char* name, const char* chosen, ImGuiComboFlags flags = 0);

// Opens the file dialog.
void open_browser(ViewState& state, BrowserPurpose purpose = BrowserPurpose::molecule);

// Two or more choices side by side; returns true when the choice changed.
bool choice(PanelContext& ctx, const char* name, std::initializer_list<const char*> labels,
            int& chosen, float width);

// A label at the left; the next item starts at a common column and takes the remaining width, less
// `reserve` pixels at scale 1.
void row_label(PanelContext& ctx, const char* label, float reserve = 0);

// A slider with its value as `text` at its right; takes the remaining width less `reserve` pixels
// at scale 1. Ctrl+click to type, within the rule.
bool value_slider(PanelContext& ctx, const char* name, double& value, double low, double high,
                  const NumberRule& rule, const std::string& text, float reserve = 0);

// Slider over 0..1 shown in percent.
bool percent_slider(PanelContext& ctx, const char* name, float& value, float low, float high);

// A line that opens a list below it; the caller ends an open one with ImGui::TreePop().
bool disclosure(PanelContext& ctx, const char* name, const std::string& title,
                const Colour& colour);

// A line in the place of a disclosure() that has nothing to list: what is below must not move when
// it comes and goes.
void nothing_to_disclose(PanelContext& ctx, const char* text);

// Keeps room for so many lines from `top` (a cursor position) on, however few were drawn.
void reserve_lines(float top, int lines);

// Between BeginPopup, BeginMenu or BeginCombo and their end: Escape closes what is open.
void close_on_escape();

bool section(PanelContext& ctx, const char* name, const char* title);

// For the last item; shown once the mouse has rested on it.
void tooltip(PanelContext& ctx, const char* text);
void muted_text(PanelContext& ctx, const std::string& text);  // one line
void muted_wrapped(PanelContext& ctx, const std::string& text);
void strong_text(PanelContext& ctx, const std::string& text);

// Lines of at most `width` pixels; they break at blanks only, never inside "1,224 atoms", so that a
// word wider than that is a line.
std::string broken_lines(const std::string& text, float width);
void wrapped_text(const std::string& text);  // in the width that is left

// `text` cut to `width` pixels with "…" in the middle where it does not fit.
std::string fitted_text(const std::string& text, float width);

}  // namespace alphascope
