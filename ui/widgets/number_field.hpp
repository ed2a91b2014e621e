// SPDX-License-Identifier: GPL-3.0-or-later
// Fields for typed numbers. ImGui's own fields drop unknown characters, so that "1,4" would become
// 14, and have no bounds.
#pragma once

#include <string>

namespace alphascope {

class Alpha;
struct NumberRule;
struct PanelContext;

// Enter, Tab or a click elsewhere accepts the typed text; Escape discards it. Text that is not a
// number within the rule does not change the value. It stays in the field, with the reason below,
// until it is corrected or the value changes. On a page a click elsewhere or Escape discards it
// too. The width is that of ImGui::SetNextItemWidth(). Returns true if the value changed.
bool number_field(PanelContext& ctx, const char* name, double& value, const NumberRule& rule);
bool number_field(PanelContext& ctx, const char* name, int& value, const NumberRule& rule);
bool number_field(PanelContext& ctx, const char* name, Alpha& value);  // kAlphaRule applies; all
                                                                       // digits are kept

// Whether a field of this dialog has a refused text. The fields of dialog "save" are named
// "save.width", ….
bool has_refused_number(PanelContext& ctx, const std::string& dialog);
// Discards a refused text: the field shows its value again.
void forget_typing(PanelContext& ctx, const std::string& name);

// For a slider or a drag that becomes a field after Ctrl+click or Enter; call this before drawing
// it. While it is a field, this draws the field instead and returns true. `changed` tells whether
// the value changed.
bool draw_typed_number(PanelContext& ctx, const char* name, double& value, const NumberRule& rule,
                       bool& changed);

bool draw_typed_number(PanelContext& ctx, const char* name, Alpha& value, bool& changed);

// Like ImGui::SliderScalar, without text on it, and with typing as above. The typed value may lie
// outside `low` and `high`, but not outside the rule.
bool number_slider(PanelContext& ctx, const char* name, double& value, double low, double high,
                   const NumberRule& rule);

}  // namespace alphascope
