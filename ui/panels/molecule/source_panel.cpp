// SPDX-License-Identifier: GPL-3.0-or-later
// The rows that choose the biological assembly and the model.
#include <algorithm>
#include <cmath>

#include "core/document/commands/commands.hpp"
#include "core/document/settings/open_options.hpp"
#include "core/document/store/key.hpp"
#include "core/molecule/assembly.hpp"
#include "core/selection/ball_options.hpp"
#include "core/text/grouped_number.hpp"
#include "ui/panels/dialogs/dialog_state.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/playback.hpp"
#include "ui/panels/view_info.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/key_focus.hpp"
#include "ui/widgets/number_field.hpp"

namespace alphascope {
namespace {

// Larger assemblies take seconds to minutes and gigabytes, so a dialog asks first.
constexpr std::uint64_t kAskFromAtoms = 300'000;

std::string number(std::uint64_t n) {
  return with_separators(static_cast<long long>(n));
}

// Counts atoms of all models, since an assembly copies all of them.
std::string atoms_text(const ViewState& s, std::uint64_t atoms) {
  const std::size_t models = s.molecule.models.size();
  return counted(atoms, "atom", "atoms") + (models > 1 ? " in " + number(models) + " models" : "");
}

std::string copies_text(const AssemblyInfo& a) {
  return number(a.copies) + (a.copies == 1 ? " copy" : " copies");
}

// Returns the memory for atoms, complex and picture, not for the atoms alone.
std::string memory_text(std::uint64_t atoms) {
  const auto [least, most] = assembly_memory(atoms);
  return bytes_text(least) + " to " + bytes_text(most) + " of memory";
}

void choose(ViewState& s, const AssemblyInfo& a) {
  if (s.settings.open.assembly == a.id) return;
  if (a.atoms >= kAskFromAtoms) {
    s.dialogs.confirm_assembly = a.id;
  } else {
    s.settings.open.assembly = a.id;
  }
}

void assembly_entries(PanelContext& ctx) {
  ViewState& s = ctx.state;
  const std::string deposited = "as deposited: " + atoms_text(s, s.molecule.deposited_atoms);
  if (ImGui::Selectable(deposited.c_str(), s.settings.open.assembly.empty())) {
    s.settings.open.assembly.clear();
  }
  record(ctx, "molecule.assembly.deposited");
  for (const AssemblyInfo& a : s.molecule.assemblies) {
    const std::string text =
        a.id + ": " + copies_text(a) + ", " + atoms_text(s, a.atoms) + ", " + memory_text(a.atoms);
    if (ImGui::Selectable(text.c_str(), s.settings.open.assembly == a.id)) choose(s, a);
    record(ctx, ("molecule.assembly." + a.id).c_str());
    if (!a.details.empty()) tooltip(ctx, a.details.c_str());
  }
}

void assembly_row(PanelContext& ctx) {
  const ViewState& s = ctx.state;
  const auto& list = s.molecule.assemblies;
  if (list.empty()) return;
  row_label(ctx, "Assembly");
  const auto chosen = std::find_if(list.begin(), list.end(), [&](const AssemblyInfo& a) {
    return a.id == s.settings.open.assembly;
  });
  const std::string preview =
      chosen == list.end() ? "as deposited" : chosen->id + ": " + copies_text(*chosen);
  const bool open = list_field(ctx, "molecule.assembly", preview.c_str());
  if (!open) {
    tooltip(ctx,
            "Biological assemblies that the file describes: copies of its chains as the molecule "
            "occurs in nature.");
    return;
  }
  assembly_entries(ctx);
  ImGui::EndCombo();
}

void play_button(PanelContext& ctx) {
  bool& playing = ctx.state.playback.models;
  if (button(ctx, "molecule.play", playing ? "Stop" : "Play", {ctx.px(44), 0})) playing = !playing;
  if (!playing) {  // while playing, a tooltip would be in the way
    tooltip(ctx, "Show the models one after the other, each with its complex at this alpha");
  }
  ImGui::SameLine(0, ctx.px(6));
}

void model_tooltip(PanelContext& ctx, int model) {
  const std::vector<int>& numbers = ctx.state.molecule.models;
  const auto index =
      std::clamp<std::size_t>(static_cast<std::size_t>(model), 0, numbers.size() - 1);
  tooltip(ctx, ("Model number " + std::to_string(numbers[index]) +
                " in the file. Alpha stays when the model changes. Ctrl+click to type.")
                   .c_str());
}

void model_slider(PanelContext& ctx) {
  ViewState& s = ctx.state;
  const int count = static_cast<int>(s.molecule.models.size());
  int& model = s.settings.open.balls.model;
  const bool every = model == kAllModels;
  int shown = every ? 1 : model + 1;
  // The text is beside the slider, whose grab would cover it. Its room fits the longest text, so
  // nothing jumps.
  const std::string all = number(s.molecule.models.size());
  const float text_width = ImGui::CalcTextSize((all + " of " + all).c_str()).x;
  const float left_for_slider = ImGui::GetContentRegionAvail().x - text_width - ctx.px(8);
  ImGui::SetNextItemWidth(std::max(left_for_slider, ctx.px(32)));
  const NumberRule rule{"The model", 1, static_cast<double>(count), "", true};
  double value = shown;
  if (number_slider(ctx, "molecule.model", value, 1, count, rule)) {
    shown = static_cast<int>(std::lround(value));
    model = shown - 1;
    s.playback.models = false;
  }
  if (!every) model_tooltip(ctx, model);
  const std::string text =
      every ? "all " + all : number(static_cast<std::uint64_t>(shown)) + " of " + all;
  const float right = ImGui::GetWindowContentRegionMax().x;
  ImGui::SameLine(right - ImGui::CalcTextSize(text.c_str()).x);
  ImGui::TextUnformatted(text.c_str());
  record(ctx, "molecule.model.text");
}

// Draws the speed in models per second.
void speed_drag(PanelContext& ctx) {
  float& speed = ctx.state.playback.models_per_second;
  double value = speed;
  bool changed = false;
  if (draw_typed_number(ctx, "molecule.speed", value, kModelSpeedRule, changed)) {
    if (changed) speed = static_cast<float>(value);
    return;
  }
  ImGui::DragFloat("##speed", &speed, 0.1f, static_cast<float>(kModelSpeedRule.least),
                   static_cast<float>(kModelSpeedRule.most), "%.1f / s",
                   ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput);
  record(ctx, "molecule.speed");
  key_stop(ctx, "molecule.speed", KeyStop::number);
}

void model_rows(PanelContext& ctx) {
  ViewState& s = ctx.state;
  if (s.molecule.models.size() < 2) return;
  row_label(ctx, "Model");
  play_button(ctx);
  model_slider(ctx);
  row_label(ctx, "");
  bool every = s.settings.open.balls.model == kAllModels;
  if (checkbox(ctx, "molecule.every_model", "All at once", every)) {
    s.settings.open.balls.model = every ? kAllModels : 0;
    s.playback.models = false;
  }
  tooltip(ctx, "The atoms of all models together, as one molecule.");
  ImGui::SameLine(0, ctx.px(8));
  ImGui::SetNextItemWidth(-1);
  speed_drag(ctx);
  tooltip(ctx,
          "Largest number of models per second while playing. Each model waits for its "
          "complex. Drag, or Ctrl+click to type.");
}

}  // namespace

void draw_source_rows(PanelContext& ctx) {
  assembly_row(ctx);
  model_rows(ctx);
}

}  // namespace alphascope
