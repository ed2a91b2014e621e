// SPDX-License-Identifier: GPL-3.0-or-later
// Collects the events of the mouse on the 3-D view.
#include <string>

#include "ui/panels/complex/clip_panel.hpp"
#include "ui/panels/frame/context_state.hpp"
#include "ui/panels/frame/mouse_state.hpp"
#include "ui/panels/frame/view_parts.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/panels/viewport_info.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {

void take_view_mouse(PanelContext& ctx, ImVec2 corner, ImVec2 size) {
  ViewportInfo& v = ctx.state.viewport;
  ImGui::SetCursorScreenPos(corner);
  ImGui::InvisibleButton("##view", size,
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  record(ctx, "view");
  const bool beside_menu =
      ctx.state.context.open && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenBlockedByPopup);
  v.hovered = false;
  if (!ctx.state.has_molecule()) return;
  const ImGuiIO& io = ImGui::GetIO();
  const bool on_view = ImGui::IsItemHovered();
  const bool hovered = on_view && !clip_handle_mouse(ctx, corner, on_view);
  v.hovered = hovered && !ImGui::IsAnyMouseDown();
  v.mouse_x = static_cast<int>(io.MousePos.x - corner.x);
  v.mouse_y = static_cast<int>(io.MousePos.y - corner.y);
  if (!v.under_mouse.empty()) tooltip(ctx, v.under_mouse.c_str());
  bool& dragging = ctx.state.mouse.dragging_view;
  const auto event = [&](PointerEvent::Kind kind, int button, double wheel) {
    v.events.push_back({kind, static_cast<int>(io.MousePos.x - corner.x),
                        static_cast<int>(io.MousePos.y - corner.y), button, wheel, io.KeyCtrl,
                        io.KeyShift});
  };
  if (dragging && (io.MouseDelta.x != 0 || io.MouseDelta.y != 0)) {
    event(PointerEvent::Kind::move, 0, 0);
  }
  bool any_down = false;
  for (int b = 0; b < 3; ++b) {
    // A press of the right button closes a menu opened elsewhere, and its release opens the menu
    // here.
    if ((hovered || (beside_menu && b == 1)) && ImGui::IsMouseClicked(b)) {
      event(PointerEvent::Kind::move, b, 0);
      event(PointerEvent::Kind::press, b, 0);
      dragging = true;
    } else if (dragging && ImGui::IsMouseReleased(b)) {
      event(PointerEvent::Kind::release, b, 0);
      // A hand that trembles moves less than this; farther, it was a drag.
      const float reach = ctx.px(4);
      if (b != 2 && io.MouseDragMaxDistanceSqr[b] <= reach * reach) {
        event(PointerEvent::Kind::click, b, 0);
        const bool twice = b == 0 && io.MouseClickedLastCount[b] == 2;
        if (twice && !io.KeyCtrl && !io.KeyShift) event(PointerEvent::Kind::double_click, b, 0);
      }
    }
    any_down = any_down || ImGui::IsMouseDown(b);
  }
  if (!any_down) dragging = false;
  if (hovered && io.MouseWheel != 0) event(PointerEvent::Kind::wheel, 0, io.MouseWheel);
}

}  // namespace alphascope
