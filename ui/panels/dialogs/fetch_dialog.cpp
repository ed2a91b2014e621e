// SPDX-License-Identifier: GPL-3.0-or-later
// The dialog that fetches a molecule by its id.
#include <imgui.h>

#include <string>

#include "core/text/printable.hpp"
#include "ui/calls.hpp"
#include "ui/panels/dialogs/dialog_stack.hpp"
#include "ui/panels/dialogs/fetch_state.hpp"
#include "ui/panels/dialogs/fields/typed_id.hpp"
#include "ui/panels/dialogs/save_target.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/style.hpp"

namespace alphascope {
namespace {

constexpr float kWidth = 464, kField = 340;  // pixels at scale 1

// The folder in which the files of this server are.
std::string folder_of(const MoleculeId& id, const FetchOptions& options) {
  if (options.folder.empty()) return {};
  return printable(fetched_file_path(options.folder, server_for(id, options)).string());
}

struct Note {
  const char* name;
  std::string text;
  bool bad = false;  // the id cannot be fetched
};

Note note_on(const TypedId& typed, const FetchState& m) {
  if (!m.problem.empty()) return {"fetch.problem", m.problem, true};
  if (!typed.fault.empty()) return {"fetch.fault", typed.fault, true};
  if (!typed.id) {
    return {"fetch.help",
            "An entry of the PDB, such as 1CRN, or a model of AlphaFold DB by its accession of "
            "UniProt, such as af:P69905."};
  }
  if (typed.before && !m.again) {
    return {"fetch.before", "Fetched before, at " + typed.before->time + ". No server is asked."};
  }
  if (m.options.offline) {
    return {"fetch.offline",
            "Nothing is fetched now (--offline or ALPHASCOPE_OFFLINE). This id was not fetched "
            "before.",
            true};
  }
  return {"fetch.ready",
          "The server gets the id, and the program's name and version, and nothing else."};
}

void row(PanelContext& ctx, const char* name, const char* label, const std::string& text) {
  row_label(ctx, label);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(fitted_text(text.empty() ? "–" : text, ctx.px(kField)).c_str());
  record(ctx, name);
  if (!text.empty()) tooltip(ctx, text.c_str());
}

}  // namespace

void draw_fetch(PanelContext& ctx) {
  FetchState& m = ctx.state.fetch;
  if (!begin_dialog(ctx, "Fetch by id")) return;
  row_label(ctx, "Id");
  ImGui::SetNextItemWidth(ctx.px(kField));
  const bool entered = text_field(ctx, "fetch.id", m.field.text, "1CRN, pdb_00001crn or af:P69905");
  const TypedId& typed = m.field.read(m.options);
  const bool known = typed.id.has_value();
  row(ctx, "fetch.server", "Server", known ? server_for(*typed.id, m.options) : "");
  row(ctx, "fetch.folder", "Kept in", known ? folder_of(*typed.id, m.options) : "");
  row_label(ctx, "");
  const bool can_repeat = typed.before && !m.options.offline;
  if (!can_repeat) m.again = false;
  ImGui::BeginDisabled(!can_repeat);
  checkbox(ctx, "fetch.again", "Fetch it again", m.again);
  ImGui::EndDisabled();
  tooltip(ctx, "Replaces the file that was fetched before by a new one.");
  const Note note = note_on(typed, m);
  two_small_lines(ctx, note.name, note.bad ? ctx.palette.warning : ctx.palette.text_muted,
                  note.text);
  ImGui::Dummy({0, ctx.px(6)});
  ImGui::NewLine();
  const bool asks = !typed.before || m.again;
  const DialogAnswer answer =
      dialog_buttons(ctx, ctx.px(kWidth), {"fetch.cancel", "Cancel"},
                     {"fetch.ok", asks ? "Fetch" : "Open"}, known && !note.bad, entered);
  if (answer == DialogAnswer::confirm) ctx.calls.files.fetch(*typed.id, m.again);
  if (answer != DialogAnswer::none) {
    m.show = m.again = false;
    m.field.clear();
  }
  end_dialog(ctx);
}

}  // namespace alphascope
