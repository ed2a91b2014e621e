// The dialog that saves the table of a page.
#include <imgui.h>

#include <filesystem>

#include "ui/panels/dialog_stack.hpp"
#include "ui/panels/format.hpp"
#include "ui/panels/picture_path.hpp"
#include "ui/panels/save_parts.hpp"
#include "ui/panels/save_target.hpp"

namespace alphascope {
namespace {

constexpr float kWidth = 464;  // pixels at scale 1

const char* ending(int format) {
  return format == 1 ? ".json" : ".csv";
}

// The name keeps its stem: "a.csv" becomes "a.json".
void format_row(PanelContext& ctx, TableMemory& memory) {
  if (!memory.table->json) return;
  row_label(ctx, "Format");
  const int before = memory.format;
  choice(ctx, "save_table.format", {"CSV", "JSON"}, memory.format, ctx.px(140));
  if (memory.format == before) return;
  std::filesystem::path path = memory.path;
  if (path.extension() == ending(before)) memory.path = path.replace_extension().string();
  memory.path += ending(memory.format);
}

void save(ViewState& s) {
  const TableMemory& memory = s.memory.save_table;
  s.requests.save_table = {memory.table, memory.format == 1,
                           path_to_save(memory.path, ending(memory.format))};
}

}  // namespace

void draw_save_table(PanelContext& ctx) {
  TableMemory& memory = ctx.state.memory.save_table;
  const std::string title = "Save: " + (memory.table ? memory.table->what : "") + "###save_table";
  if (memory.table) {
    const std::string& name = memory.table->file_name;
    propose_file(ctx, title.c_str(), name, memory.path, name + ending(memory.format));
  }
  if (!begin_dialog(ctx, title.c_str())) return;
  if (!memory.table) return end_dialog(ctx);
  const bool entered = file_row(ctx, "save_table", memory.path);
  const bool can_save =
      save_target(ctx, "save_table", {path_to_save(memory.path, ending(memory.format))}) &&
      !memory.path.empty();
  format_row(ctx, memory);
  row_label(ctx, "");
  ImGui::PushFont(ctx.fonts.small);
  muted_text(ctx, "All digits, and file, selection, radii, alpha and program with them.");
  ImGui::PopFont();
  ImGui::Dummy({0, ctx.px(6)});
  ImGui::NewLine();
  const DialogAnswer answer = dialog_buttons(ctx, ctx.px(kWidth), {"save_table.cancel", "Cancel"},
                                             {"save_table.ok", "Save"}, can_save);
  const bool confirmed = answer == DialogAnswer::confirm || (entered && can_save);
  if (confirmed) save(ctx.state);
  if (confirmed || answer == DialogAnswer::cancel) {
    note_file(ctx, memory.table->file_name, memory.path, confirmed);
    memory.table = nullptr;
  }
  end_dialog(ctx);
}

}  // namespace alphascope
