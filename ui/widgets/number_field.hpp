// Fields for typed numbers. ImGui's own drop characters that they do not know, so that "1,4" would
// become 14, and know no bounds.
#pragma once

#include <string>

#include "core/document/commands/number_input.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {

// Enter, Tab or a click elsewhere takes what was typed; Escape takes it back. What is no number
// within the rule changes nothing: it stays in the field to be mended, with the reason below it,
// until its value changes; on a page, until a click elsewhere or Escape as well.
// Width as ImGui::SetNextItemWidth(). True when the value changed.
bool number_field(PanelContext& ctx, const char* name, double& value, const NumberRule& rule);
bool number_field(PanelContext& ctx, const char* name, int& value, const NumberRule& rule);
bool number_field(PanelContext& ctx, const char* name, Alpha& value);  // by kAlphaRule, exactly

// Does a field of this dialog have what is no number ("save": fields "save.width", …)?
bool has_refused_number(PanelContext& ctx, const std::string& dialog);
// The field shows its value again.
void forget_typing(PanelContext& ctx, const std::string& name);

// A slider or a drag that becomes a field upon Ctrl+click. Call before it: true while it is a
// field, which is then drawn in its place; `changed` tells whether the value changed.
bool typed_instead(PanelContext& ctx, const char* name, double& value, const NumberRule& rule,
                   bool& changed);

bool typed_instead(PanelContext& ctx, const char* name, Alpha& value, bool& changed);

// As ImGui::SliderScalar, without text on it, and with typing as above. The value may be typed
// beyond `low` and `high`, but within the rule.
bool number_slider(PanelContext& ctx, const char* name, double& value, double low, double high,
                   const NumberRule& rule);

}  // namespace alphascope
