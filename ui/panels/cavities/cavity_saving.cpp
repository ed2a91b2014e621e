// SPDX-License-Identifier: GPL-3.0-or-later
// Saves the table of cavities: rows as CSV or JSON, and shapes and scripts for other programs.
#include <string>
#include <vector>

#include "core/document/cavities/cavity_export.hpp"
#include "core/document/cavities/cavity_tables.hpp"
#include "core/document/export/record_source.hpp"
#include "core/document/store/inputs.hpp"
#include "ui/panels/cavities/cavity_page.hpp"
#include "ui/panels/cavities/cavity_parts.hpp"
#include "ui/panels/dialogs/save_parts.hpp"
#include "ui/panels/dialogs/table_to_save.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

std::vector<FormatToSave> exports_of(const CavityRowsWanted& rows, const RecordSource& source) {
  std::vector<FormatToSave> formats;
  for (const ShapeExportInfo& info : cavity_exports()) {
    formats.push_back(format_to_save(info, cavity_export(info, rows, source)));
  }
  return formats;
}

}  // namespace

void cavity_save_button(PanelContext& ctx, const CavityPage& page, bool current) {
  ImGui::BeginDisabled(!current || page.order.empty() || !ctx.inputs.complex);
  if (button(ctx, "cavities.save", "Save…")) {
    const CavityFilter& filter = page.filter;
    CavityRowsWanted rows{filter.kind != 2, filter.kind != 1, {}};
    if (filter.least_volume_angstrom3 != 0) {
      rows.least_volume_sa_angstrom3 = filter.least_volume_angstrom3;
    }
    const RecordSource source = source_on_screen(ctx);
    open_save_dialog(ctx,
                     {"Cavities", file_name_for(ctx, "cavities"), cavities_as_csv(rows, source),
                      cavities_as_json(rows, source), ctx.inputs, true, exports_of(rows, source)});
  }
  ImGui::EndDisabled();
  tooltip(ctx,
          "Saves the listed cavities with all their values as CSV or JSON. Or saves surfaces, "
          "filling spheres or a script for other programs.");
}

}  // namespace alphascope
