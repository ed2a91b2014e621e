// SPDX-License-Identifier: GPL-3.0-or-later
// Draws ImGui's field for a colour, and makes both its parts stops of Tab.
#include "ui/widgets/colour_field.hpp"

#include <imgui.h>
// Needs imgui.h first.
#include <imgui_internal.h>

#include "ui/theme.hpp"
#include "ui/widgets/key_focus.hpp"

namespace alphascope {

bool colour_field(PanelContext& ctx, const std::string& name, Colour& colour) {
  const std::string label = "##" + name, patch = name + ".patch";
  float rgb[3] = {colour.r, colour.g, colour.b};
  const bool changed = ImGui::ColorEdit3(label.c_str(), rgb, ImGuiColorEditFlags_DisplayHex);
  if (changed) colour = {rgb[0], rgb[1], rgb[2], 1};
  // ImGui reports the field as one item without an id; these are the ids of its parts.
  ImGui::PushID(label.c_str());
  const ImGuiID digits_id = ImGui::GetID("##Text"), patch_id = ImGui::GetID("##ColorButton");
  ImGui::PopID();
  ImGuiLastItemData& last = GImGui->LastItemData;
  const ImGuiLastItemData whole = last;
  const float side = ImGui::GetFrameHeight();
  record(ctx, name.c_str());
  last.StatusFlags &= ~ImGuiItemStatusFlags_HasDeactivated;
  last.ID = digits_id;
  last.Rect.Max.x = whole.Rect.Max.x - side - ImGui::GetStyle().ItemInnerSpacing.x;
  key_stop(ctx, name.c_str(), KeyStop::type_when_asked);
  note_enter(ctx, name.c_str());
  last.ID = patch_id;
  last.Rect = whole.Rect;
  last.Rect.Min.x = whole.Rect.Max.x - side;
  record(ctx, patch.c_str());
  key_stop(ctx, patch.c_str());
  last = whole;  // for tooltips
  return changed;
}

}  // namespace alphascope
