// SPDX-License-Identifier: GPL-3.0-or-later
// Keyboard control of fields and buttons. Tab goes from one to the next, Space and Enter press
// them, Alt and F10 open the menu bar. ImGui 1.86 leads Tab to text fields only, and its own
// navigation would take the arrow keys from alpha. So that navigation is on in menus and lists
// only.
#pragma once

#include "ui/widgets/key_state.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {

// Call before ImGui's NewFrame: turns on ImGui's navigation while a menu or list is open.
void prepare_list_keys();

// Call begin_key_focus() after NewFrame and before all widgets, end_key_focus() after them.
void begin_key_focus(PanelContext& ctx);
void end_key_focus(PanelContext& ctx);

// Makes the last item a stop of Tab.
void key_stop(PanelContext& ctx, const char* name, KeyStop kind = KeyStop::press);
// Notes whether Enter has just ended typing in the last item. It then confirms the dialog
// (dialog_stack.cpp).
void note_enter(PanelContext& ctx, const char* name);
// Whether Enter or Space has asked this slider to become a field. Returns true once.
bool wants_typing(PanelContext& ctx, const std::string& name);
// Number of steps by which arrow keys move this slider in this frame.
int key_steps(PanelContext& ctx, const std::string& name);
// Directs typing, from the next frame on, to the end of this field. It must have been drawn in the
// last frame.
void type_into(PanelContext& ctx, const std::string& name);
// Flags and callback for ImGui::InputText(), which place the caret in the field KeyState::caret.
ImGuiInputTextFlags caret_flags(const PanelContext& ctx, const char* name);
int place_caret(ImGuiInputTextCallbackData* data);  // data->UserData must be the KeyState
// Ends any typing in a field.
void stop_typing();

}  // namespace alphascope
