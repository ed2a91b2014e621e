// SPDX-License-Identifier: GPL-3.0-or-later
// The start page, in the place of the picture while no molecule is open: three doors, ways to open
// a molecule, and recent files.
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "core/document/commands/commands.hpp"
#include "core/document/settings/request.hpp"
#include "core/read/file_format.hpp"
#include "core/text/printable.hpp"
#include "ui/calls.hpp"
#include "ui/panels/dialogs/fetch_state.hpp"
#include "ui/panels/frame/overlay.hpp"
#include "ui/panels/frame/start_state.hpp"
#include "ui/panels/frame/view_parts.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/view_info.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/running_job.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/key_focus.hpp"
#include "ui/widgets/style.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

// Pixels at scale 1.
constexpr float kMostWidth = 680, kLeastWidth = 300, kMargin = 10, kGap = 10;
constexpr float kOneColumnBelow = 470;
constexpr float kDoorHeight = 50, kLowDoorHeight = 34;
constexpr double kWaterRadius = 1.4;                // Å
constexpr float kLeastRecent = 4, kMostRecent = 8;  // that are listed, by the room there is

// What fits into the view.
struct Fit {
  float width = 0, most = 0;  // of the page's contents, and their largest height; pixels
  bool low = false;           // leave out all that can be left out
};

// Opens the sample with the largest molecule, or the file dialog if there are no samples.
std::filesystem::path open_sample(PanelContext& ctx) {
  const auto& samples = ctx.state.samples;
  if (samples.empty()) {
    open_browser(ctx.state);
    return {};
  }
  ctx.calls.files.open(samples.back().path);
  return samples.back().path;
}

// Without a solvent most of the empty space is one pocket.
void find_cavities(PanelContext& ctx) {
  open_sample(ctx);
  double& solvent = ctx.state.settings.request.solvent_radius_angstrom;
  if (solvent == 0) solvent = kWaterRadius;
  ctx.state.show_page("cavities");
}

void make_picture(PanelContext& ctx) {
  ctx.state.start.picture_of = open_sample(ctx);
}

void learn(PanelContext& ctx) {
  ctx.commands.run("lesson.open");
}

struct Door {
  const char *name, *title, *below, *help;
  bool of_sample;  // it opens a molecule
  void (*open)(PanelContext& ctx);
};

constexpr Door kDoors[] = {
    {"start.cavities", "Find cavities", "in a sample molecule",
     "Opens the sample with a solvent radius of 1.4 Å, and the page Cavities, which lists pockets "
     "and voids.",
     true, find_cavities},
    {"start.picture", "Make a picture", "of a sample molecule",
     "Opens the sample and the dialog that saves a picture.", true, make_picture},
    {"start.learn", "Learn", "by lessons beside the view",
     "Lists the lessons. Each shows an idea in the window, step by step.", false, learn}};

// A button with a second line in small letters, if it is high enough.
bool door(PanelContext& ctx, const Door& d, ImVec2 size, bool low) {
  if (low) return button(ctx, d.name, d.title, size, ButtonKind::primary);
  const std::string label = std::string("##") + d.name;
  const bool clicked = button(ctx, d.name, label.c_str(), size);
  const ImVec2 corner = ImGui::GetItemRectMin();
  ImDrawList* const draw = ImGui::GetWindowDrawList();
  const auto centred = [&](ImFont* font, const char* text, float y, const Colour& colour) {
    ImGui::PushFont(font);
    const std::string shown = fitted_text(text, size.x - ctx.px(12));
    const float x = corner.x + (size.x - ImGui::CalcTextSize(shown.c_str()).x) / 2;
    draw->AddText({x, corner.y + y}, to_u32(colour), shown.c_str());
    ImGui::PopFont();
  };
  centred(ctx.fonts.strong, d.title, ctx.px(7), ctx.palette.text);
  const bool asks = d.of_sample && ctx.state.samples.empty();
  centred(ctx.fonts.small, asks ? "of a file that you choose" : d.below, ctx.px(28),
          ctx.palette.text_muted);
  return clicked;
}

void doors(PanelContext& ctx, const Fit& fit) {
  const float gap = ctx.px(kGap), count = static_cast<float>(std::size(kDoors));
  const ImVec2 size{(fit.width - (count - 1) * gap) / count,
                    ctx.px(fit.low ? kLowDoorHeight : kDoorHeight)};
  for (const Door& d : kDoors) {
    if (&d != kDoors) ImGui::SameLine(0, gap);
    if (door(ctx, d, size, fit.low)) d.open(ctx);
    tooltip(ctx, d.help);
  }
}

// The field for an id, and one line on what was typed.
void fetch_field(PanelContext& ctx, float width) {
  IdField& field = ctx.state.start.field;
  const FetchState& fetch = ctx.state.fetch;
  const float each = ctx.px(64), gap = ctx.px(6);
  ImGui::SetNextItemWidth(width - each - gap);
  const bool entered =
      text_field(ctx, "start.id", field.text, "1CRN or af:P69905", KeyStop::type_when_asked);
  const TypedId& typed = field.read(fetch.options);
  ImGui::SameLine(0, gap);
  const bool offline = typed.id && !typed.before && fetch.options.offline;
  const bool can = typed.id && fetch.problem.empty() && !offline;
  ImGui::BeginDisabled(!can);
  const bool clicked = button(ctx, "start.fetch", typed.before ? "Open" : "Fetch", {each, 0});
  ImGui::EndDisabled();
  if (can && (clicked || entered)) ctx.calls.files.fetch(*typed.id, false);
  const std::string note = !fetch.problem.empty() ? fetch.problem
                           : !typed.fault.empty() ? typed.fault
                           : offline              ? "Nothing is fetched now (offline)."
                           : typed.before         ? "Fetched before; no server is asked."
                           : typed.id             ? "From " + server_for(*typed.id, fetch.options)
                                                  : "By id, from PDB or AlphaFold DB";
  ImGui::PushFont(ctx.fonts.small);
  const bool bad = !fetch.problem.empty() || !typed.fault.empty() || offline;
  ImGui::TextColored(to_imgui(bad ? ctx.palette.warning : ctx.palette.text_muted), "%s",
                     fitted_text(note, width).c_str());
  record(ctx, "start.id_note");
  tooltip(ctx, note.c_str());
  ImGui::PopFont();
}

void samples(PanelContext& ctx, float width) {
  const auto& all = ctx.state.samples;
  const float gap = ctx.px(6), count = static_cast<float>(all.size());
  const float each = (width - (count - 1) * gap) / std::max(1.0f, count);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i > 0) ImGui::SameLine(0, gap);
    const std::string name = "start.sample." + std::to_string(i);
    if (button(ctx, name.c_str(), fitted_text("Try " + all[i].name, each - ctx.px(8)).c_str(),
               {each, 0})) {
      ctx.calls.files.open(all[i].path);
    }
    tooltip(ctx, all[i].detail.c_str());
  }
}

void open_column(PanelContext& ctx, float width) {
  ImGui::BeginGroup();
  strong_text(ctx, "Open");
  if (button(ctx, "start.open", "Open file…", {width, 0}, ButtonKind::primary)) {
    open_browser(ctx.state);
  }
  tooltip(ctx, ("Ctrl+O, or drop a file here: " + format_names() + "; plain or .gz.").c_str());
  samples(ctx, width);
  fetch_field(ctx, width);
  ImGui::EndGroup();
}

// A recent file by its name, or by its id if it was fetched.
void recent_row(PanelContext& ctx, const Choice& file, std::size_t n, float width) {
  const std::string name = "start.recent." + std::to_string(n);
  const bool clicked = ImGui::Selectable(("##" + name).c_str(), false, 0,
                                         {width, ImGui::GetTextLineHeight() + ctx.px(2)});
  record(ctx, name.c_str());
  key_stop(ctx, name.c_str());
  const ImVec2 corner = ImGui::GetItemRectMin();
  const std::string title = fitted_text(file.title, width - ctx.px(8));
  ImDrawList* const draw = ImGui::GetWindowDrawList();
  draw->AddText({corner.x + ctx.px(4), corner.y + ctx.px(1)}, to_u32(ctx.palette.text),
                title.c_str());
  const float used = ImGui::CalcTextSize(title.c_str()).x + ctx.px(16);
  ImGui::PushFont(ctx.fonts.small);
  if (width - used > ctx.px(40)) {
    draw->AddText({corner.x + used, corner.y + ctx.px(3)}, to_u32(ctx.palette.text_muted),
                  fitted_text(file.detail, width - used).c_str());
  }
  ImGui::PopFont();
  tooltip(ctx, printable(file.id).c_str());
  const CommandSpec* const command = ctx.commands.find("file.recent");
  if (clicked && command) run_command(ctx, *command, {file.id});
}

void recent_column(PanelContext& ctx, const Fit& fit, float width) {
  const float row = ImGui::GetTextLineHeight() + ctx.px(2) + ImGui::GetStyle().ItemSpacing.y;
  const float foot = fit.low ? 0 : ctx.px(30);
  const float rows = (fit.most - foot - ImGui::GetCursorPosY()) / row - 1;
  ImGui::BeginGroup();
  strong_text(ctx, "Recent files");
  const auto room = static_cast<std::size_t>(std::clamp(rows, kLeastRecent, kMostRecent));
  const std::size_t count = std::min(ctx.state.recent.size(), room);
  const CommandSpec* const command = ctx.commands.find("file.recent");
  const std::vector<Choice> files =
      command && count > 0 ? command->first_required()->choices() : std::vector<Choice>();
  if (files.empty()) muted_wrapped(ctx, "Files that you open will be listed here.");
  for (std::size_t n = 0; n < std::min(count, files.size()); ++n) {
    recent_row(ctx, files[n], n, width);
  }
  ImGui::EndGroup();
}

void contents(PanelContext& ctx, const Fit& fit) {
  if (!fit.low) {
    ImGui::PushFont(ctx.fonts.large);
    ImGui::TextUnformatted("Open a molecule to begin");
    ImGui::PopFont();
    ImGui::Dummy({0, ctx.px(2)});
  }
  doors(ctx, fit);
  ImGui::Dummy({0, ctx.px(fit.low ? 0 : 4)});
  const bool one_column = fit.width < ctx.px(kOneColumnBelow);
  const float gap = ctx.px(2 * kGap), width = one_column ? fit.width : (fit.width - gap) / 2;
  open_column(ctx, width);
  if (!one_column) ImGui::SameLine(0, gap);
  recent_column(ctx, fit, width);
  if (fit.low) return;
  ImGui::Dummy({0, ctx.px(2)});
  ImGui::PushFont(ctx.fonts.small);
  muted_text(ctx, "You can also drop a file here. F1: mouse and keyboard. Ctrl+P: all commands.");
  ImGui::PopFont();
}

}  // namespace

void draw_start_page(PanelContext& ctx, ImVec2 corner, ImVec2 size) {
  if (ctx.state.molecule.loaded || awaited_job(ctx.state.jobs) != nullptr) return;
  const ImVec2 padding = ImGui::GetStyle().WindowPadding;
  Fit fit;
  fit.width = std::clamp(size.x - 2 * (ctx.px(kMargin) + padding.x), ctx.px(kLeastWidth),
                         ctx.px(kMostWidth));
  constexpr float kLow = 270;  // pixels at scale 1
  fit.low = size.y < ctx.px(kLow);
  float& wanted = ctx.state.start.height;  // of the contents in the last frame
  fit.most = std::max(ctx.px(80), size.y - 2 * (ctx.px(kMargin) / 2 + padding.y));
  const float height = wanted > 0 ? std::min(wanted, fit.most) : fit.most;
  begin_overlay(ctx, "##start", {corner.x + size.x / 2, corner.y + size.y / 2}, {0.5f, 0.5f});
  // It scrolls where the view is too low.
  const float bar = wanted > fit.most ? ImGui::GetStyle().ScrollbarSize : 0;
  ImGui::BeginChild("start", {fit.width + bar, height}, false);
  contents(ctx, fit);
  wanted = ImGui::GetCursorPosY();
  ImGui::EndChild();
  end_overlay();
}

}  // namespace alphascope
