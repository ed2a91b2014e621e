// SPDX-License-Identifier: GPL-3.0-or-later
// A field for a colour: hexadecimal digits, and a patch that opens a picker.
#pragma once

#include <string>

namespace alphascope {

struct Colour;
struct PanelContext;

// Tab leads to the digits, named `name`, and then to the patch, named `name`.patch. The width is
// that of ImGui::SetNextItemWidth(). Returns whether the colour changed. It is opaque.
bool colour_field(PanelContext& ctx, const std::string& name, Colour& colour);

}  // namespace alphascope
