// SPDX-License-Identifier: GPL-3.0-or-later
// The dialog that saves the table of a page, as CSV, JSON or a format for another program.
#include <imgui.h>

#include <filesystem>
#include <string_view>
#include <vector>

#include "core/files/output_ending.hpp"
#include "core/text/as_sentence.hpp"
#include "ui/calls.hpp"
#include "ui/panels/dialogs/dialog_stack.hpp"
#include "ui/panels/dialogs/fields/typed_path.hpp"
#include "ui/panels/dialogs/save_parts.hpp"
#include "ui/panels/dialogs/save_target.hpp"
#include "ui/panels/dialogs/table_state.hpp"
#include "ui/panels/dialogs/table_to_save.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/style.hpp"

namespace alphascope {
namespace {

constexpr float kWidth = 464;  // pixels at scale 1

const FormatToSave* other_format(const TableToSave& table, int format) {
  if (format < kFirstOfMore) return nullptr;
  return &table.more[static_cast<std::size_t>(format - kFirstOfMore)];
}

std::string ending(const TableToSave& table, int format) {
  if (const FormatToSave* other = other_format(table, format)) return other->ending;
  return format == kJsonFormat ? ".json" : ".csv";
}

std::string name(const TableToSave& table, int format) {
  if (const FormatToSave* other = other_format(table, format)) return other->name;
  return format == kJsonFormat ? "JSON" : "CSV";
}

std::vector<int> formats(const TableToSave& table) {
  std::vector<int> all{kCsvFormat};
  if (table.json) all.push_back(kJsonFormat);
  for (std::size_t n = 0; n < table.more.size(); ++n) {
    all.push_back(kFirstOfMore + static_cast<int>(n));
  }
  return all;
}

// Chooses the format by the typed ending. A name without one keeps the format, whose ending is
// added later. Returns the fault of an unknown ending; empty: none.
std::string follow_ending(TableState& memory) {
  std::vector<std::string> endings;
  std::vector<std::string_view> views;
  const std::string typed = output_ending(memory.path);
  for (const int format : formats(*memory.table)) {
    endings.push_back(ending(*memory.table, format));
    if (endings.back() == typed) memory.format = format;
  }
  for (const std::string& one : endings) views.push_back(one);
  return fault_of_ending(memory.path, views);
}

std::filesystem::path target(const TableState& memory) {
  return path_to_save(memory.path, ending(*memory.table, memory.format));
}

std::vector<std::filesystem::path> targets(const TableState& memory) {
  const FormatToSave* other = other_format(*memory.table, memory.format);
  return other ? other->files(target(memory)) : std::vector{target(memory)};
}

// Changes the format and the name's ending with it: "a.csv" becomes "a.json".
void choose_format(TableState& memory, int format) {
  std::filesystem::path path = memory.path;
  if (output_ending(path) == ending(*memory.table, memory.format)) {
    memory.path = path.replace_extension().string();
  }
  memory.format = format;
  memory.path += ending(*memory.table, format);
}

void format_row(PanelContext& ctx, TableState& memory) {
  const TableToSave& table = *memory.table;
  if (formats(table).size() < 2) return;
  row_label(ctx, "Format");
  if (table.more.empty()) {
    int format = memory.format;
    choice(ctx, "save_table.format", {"CSV", "JSON"}, format, ctx.px(140));
    if (format != memory.format) choose_format(memory, format);
    return;
  }
  ImGui::SetNextItemWidth(ctx.px(200));
  if (!list_field(ctx, "save_table.format", name(table, memory.format).c_str(),
                  ImGuiComboFlags_HeightLarge)) {
    return;
  }
  for (const int format : formats(table)) {
    if (ImGui::Selectable(name(table, format).c_str(), format == memory.format)) {
      choose_format(memory, format);
    }
    record(ctx, ("save_table" + ending(table, format)).c_str());
  }
  ImGui::EndCombo();
}

// Describes the contents of the format. If it is several files, names the others too.
std::string content_text(const TableState& memory) {
  const FormatToSave* other = other_format(*memory.table, memory.format);
  if (!other)
    return "The file has all digits, and records file, selection, radii, alpha and program.";
  std::string text = as_sentence(other->what);
  const std::vector<std::filesystem::path> files = targets(memory);
  for (std::size_t k = 1; k < files.size(); ++k) {
    text += (k == 1 ? "\nAlso written: " : ", ") + files[k].filename().string();
  }
  return text + (files.size() > 1 ? "." : "");
}

void save(PanelContext& ctx) {
  const TableState& memory = ctx.state.save_table;
  ctx.calls.jobs.save_table({memory.table, memory.format, target(memory)});
}

}  // namespace

void draw_save_table(PanelContext& ctx) {
  TableState& memory = ctx.state.save_table;
  const std::string title = "Save: " + (memory.table ? memory.table->what : "") + "###save_table";
  if (memory.table) {
    const std::string& name = memory.table->file_name;
    propose_file(ctx, title.c_str(), "", memory.path, name + ending(*memory.table, memory.format));
  }
  if (!begin_dialog(ctx, title.c_str())) return;
  if (!memory.table) return end_dialog(ctx);
  const bool entered = file_row(ctx, "save_table", memory.path);
  const std::string fault = follow_ending(memory);
  const bool can_save = save_target(ctx, "save_table", targets(memory), fault);
  format_row(ctx, memory);
  row_label(ctx, "");
  ImGui::PushFont(ctx.fonts.small);
  muted_text(ctx, content_text(memory));
  ImGui::PopFont();
  ImGui::Dummy({0, ctx.px(6)});
  ImGui::NewLine();
  const DialogAnswer answer = dialog_buttons(ctx, ctx.px(kWidth), {"save_table.cancel", "Cancel"},
                                             {"save_table.ok", "Save"}, can_save, entered);
  const bool confirmed = answer == DialogAnswer::confirm;
  if (confirmed) save(ctx);
  if (confirmed || answer == DialogAnswer::cancel) {
    note_file(ctx, "", memory.path);
    memory.table = nullptr;
  }
  end_dialog(ctx);
}

}  // namespace alphascope
