// SPDX-License-Identifier: GPL-3.0-or-later
// The list of the parts of chosen cavities that are drawn, with their opacity.
#include <string>
#include <string_view>
#include <utility>

#include "ui/layer.hpp"
#include "ui/panels/cavities/cavity_page.hpp"
#include "ui/panels/cavities/cavity_parts.hpp"
#include "ui/panels/complex/display_rows.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {

void cavity_parts_button(PanelContext& ctx, CavityPage& page) {
  if (button(ctx, "cavities.draw", "Draw")) ImGui::OpenPopup("cavities.draw");
  tooltip(ctx, "Chooses the parts of selected cavities that are drawn.");
  if (!ImGui::BeginPopup("cavities.draw")) return;
  close_on_escape();
  DrawnCavityParts& parts = page.parts;
  checkbox(ctx, "cavities.draw.surfaces", "surface", parts.surfaces);
  checkbox(ctx, "cavities.draw.tetrahedra", "tetrahedra", parts.tetrahedra);
  checkbox(ctx, "cavities.draw.spheres", "filling spheres", parts.spheres);
  tooltip(ctx,
          "Spheres that fill the cavity and touch the atoms around it, without the solvent "
          "radius.");
  checkbox(ctx, "cavities.draw.rims", "rims of mouths", parts.rims);
  checkbox(ctx, "cavities.draw.numbers", "numbers", parts.numbers);
  ImGui::Separator();
  if (checkbox(ctx, "cavities.draw.fade", "fade the rest", page.fades_rest)) {
    page.layers_are_old = true;
  }
  tooltip(ctx, ("Balls, simplices and objects are at most " + percent_text(kFadedOpacity) +
                " opaque, whatever is set, so that they do not hide the cavity. Its contents are "
                "drawn in front of everything else.")
                   .c_str());
  display_row(ctx, &DisplaySettings::lining_sticks);
  ImGui::Dummy({ctx.px(240), 0});  // a width, since the slider takes all there is
  muted_text(ctx, "Opacity");
  const std::pair<const char*, DisplayField::Member> opacities[] = {
      {"Cavities", &DisplaySettings::cavity_opacity},
      {"Lining", &DisplaySettings::lining_opacity},
      {"Ligands", &DisplaySettings::content_opacity}};
  for (const auto& [label, member] : opacities) {
    const DisplayField& field = display_field(member);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label);
    ImGui::SameLine(ctx.px(90));
    const bool usual = std::string_view(field.id) == "cavity_opacity";
    const std::string name = std::string("cavities.draw.") + (usual ? "opacity" : field.id);
    display_slider(ctx, field, name.c_str());
  }
  ImGui::EndPopup();
}

}  // namespace alphascope
