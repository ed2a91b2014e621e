// The keyboard among fields and buttons: Tab leads from one to the next, Space and Enter press
// them, Alt and F10 open the menu bar. ImGui 1.86 leads Tab to text fields only, and with its own
// navigation the arrow keys would no longer be alpha's, so that is on in menus and lists alone.
#pragma once

#include "ui/widgets/key_memory.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {

// Before ImGui's NewFrame: whether arrow keys choose in a menu or list.
void prepare_list_keys();

// After NewFrame and before all widgets; behind them.
void begin_key_focus(PanelContext& ctx);
void end_key_focus(PanelContext& ctx);

// The last item is one that Tab leads to.
void key_stop(PanelContext& ctx, const char* name, KeyStop kind = KeyStop::press);
// Once, when Enter or Space wants this slider to be a field.
bool wants_typing(PanelContext& ctx, const std::string& name);
// By how many steps an arrow key moves this slider in this frame.
int key_steps(PanelContext& ctx, const std::string& name);
// What is typed from the next frame on goes to the end of this field, which must have been drawn in
// the last.
void type_into(PanelContext& ctx, const std::string& name);
// For ImGui::InputText(): its flags and callback that place the caret where KeyMemory::caret says.
ImGuiInputTextFlags caret_flags(const PanelContext& ctx, const char* name);
int place_caret(ImGuiInputTextCallbackData* data);  // its user data: the KeyMemory
// Whatever was being typed is over.
void stop_typing();

}  // namespace alphascope
