// SPDX-License-Identifier: GPL-3.0-or-later
// Copies the profile of a channel, and saves the channel for spreadsheets and other programs.
#include <memory>
#include <string>
#include <vector>

#include "core/chart/svg.hpp"
#include "core/document/channels/channel_export.hpp"
#include "core/document/channels/channel_records.hpp"
#include "core/document/store/inputs.hpp"
#include "ui/panels/channels/channel_parts.hpp"
#include "ui/panels/dialogs/save_parts.hpp"
#include "ui/panels/dialogs/table_to_save.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

std::vector<FormatToSave> exports_of(const std::shared_ptr<const FoundChannel>& found,
                                     const RecordSource& source, const std::string& title) {
  std::vector<FormatToSave> formats;
  for (const ShapeExportInfo& info : channel_exports()) {
    formats.push_back(format_to_save(info, channel_export(info, found, source)));
  }
  formats.push_back(figure_to_save(plot_svg(profile_plot(*found->channel), title)));
  return formats;
}

}  // namespace

void channel_save_buttons(PanelContext& ctx, const std::shared_ptr<const FoundChannel>& found) {
  const RecordSource source = source_on_screen(ctx);
  if (button(ctx, "channels.copy", "Copy profile")) {
    ImGui::SetClipboardText(channel_csv_text(*found->channel, source).c_str());
    ctx.state.notice = "Profile copied as CSV: " +
                       with_separators(static_cast<long long>(found->channel->samples.size())) +
                       " rows.";
  }
  tooltip(ctx, "Copies length, radius and position every 0.1 Å as CSV for a spreadsheet.");
  ImGui::SameLine(0, ctx.px(8));
  if (button(ctx, "channels.save", "Save…")) {
    open_save_dialog(ctx, {"Channel",
                           file_name_for(ctx, "channel"),
                           channel_csv(found, source),
                           channel_as_json(found, source),
                           {},
                           false,
                           exports_of(found, source, ctx.state.file_name())});
  }
  tooltip(ctx,
          "The profile as a CSV or SVG file, the channel as a JSON file, or its surface, spheres "
          "along it or a script for other programs.");
}

}  // namespace alphascope
