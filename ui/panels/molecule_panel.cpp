// What is open, what was used of it and what was dropped.
#include "ui/panels/format.hpp"
#include "ui/panels/panels.hpp"

namespace alphascope {
namespace {

void sample_popup(PanelContext& ctx) {
  ViewState& s = ctx.state;
  if (!ImGui::BeginPopup("samples")) return;
  for (std::size_t i = 0; i < s.samples.size(); ++i) {
    if (ImGui::MenuItem(s.samples[i].name.c_str(), s.samples[i].detail.c_str())) {
      s.requests.open_sample = i;
    }
    record(ctx, ("molecule.sample." + std::to_string(i)).c_str());
  }
  ImGui::EndPopup();
}

void open_buttons(PanelContext& ctx) {
  ViewState& s = ctx.state;
  const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
  const auto kind = s.molecule.loaded ? ButtonKind::normal : ButtonKind::primary;
  if (button(ctx, "molecule.open", "Open…", {half, 0}, kind)) s.memory.show_browser = true;
  ImGui::SameLine();
  ImGui::BeginDisabled(s.samples.empty());
  if (button(ctx, "molecule.sample", "Sample molecule", {half, 0})) ImGui::OpenPopup("samples");
  ImGui::EndDisabled();
  if (s.samples.empty()) tooltip(ctx, "The folder with the sample molecules was not found.");
  sample_popup(ctx);
}

void radii_row(PanelContext& ctx) {
  ViewState& s = ctx.state;
  if (s.radii_sets.empty()) return;
  row_label(ctx, "Radii");
  const auto& chosen = s.radii_sets[static_cast<std::size_t>(s.selection.radii_set)];
  const bool open = ImGui::BeginCombo("##radii", chosen.name.c_str());
  record(ctx, "molecule.radii");
  if (!open) {
    tooltip(ctx, chosen.citation.c_str());
    return;
  }
  for (std::size_t i = 0; i < s.radii_sets.size(); ++i) {
    const bool on = static_cast<int>(i) == s.selection.radii_set;
    if (ImGui::Selectable(s.radii_sets[i].name.c_str(), on)) {
      s.selection.radii_set = static_cast<int>(i);
    }
    record(ctx, ("molecule.radii." + std::to_string(i)).c_str());
    tooltip(ctx, s.radii_sets[i].citation.c_str());
  }
  ImGui::EndCombo();
}

void selection(PanelContext& ctx) {
  SelectionControls& c = ctx.state.selection;
  radii_row(ctx);
  row_label(ctx, "Hydrogens");
  int hydrogens = static_cast<int>(c.hydrogens);
  choice(ctx, "molecule.hydrogens", {"auto", "keep", "drop"}, hydrogens,
         ImGui::GetContentRegionAvail().x);
  c.hydrogens = static_cast<HydrogenOption>(hydrogens);
  checkbox(ctx, "molecule.waters", "Waters", c.waters);
  ImGui::SameLine(0, ctx.px(16));
  checkbox(ctx, "molecule.ligands", "Ligands", c.ligands);
  ImGui::SameLine(0, ctx.px(16));
  checkbox(ctx, "molecule.ions", "Ions", c.ions);
}

void notes(PanelContext& ctx) {
  const auto& list = ctx.state.molecule.notes;
  if (list.empty()) return;
  const std::string title =
      list.size() == 1
          ? "1 note on this molecule"
          : with_separators(static_cast<long long>(list.size())) + " notes on this molecule";
  ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(ctx.palette.warning));
  const bool open =
      ImGui::TreeNodeEx("notes", ImGuiTreeNodeFlags_SpanAvailWidth, "%s", title.c_str());
  ImGui::PopStyleColor();
  record(ctx, "molecule.notes");
  if (!open) return;
  for (const std::string& note : list) muted_wrapped(ctx, note);
  ImGui::TreePop();
}

}  // namespace

void draw_molecule_panel(PanelContext& ctx) {
  if (!section(ctx, "molecule", "Molecule")) return;
  open_buttons(ctx);
  const MoleculeInfo& m = ctx.state.molecule;
  if (!m.loaded) {
    muted_wrapped(ctx, "Nothing is open yet.");
    return;
  }
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::PushFont(ctx.fonts.strong);
  ImGui::TextUnformatted(fitted_text(m.name, width).c_str());
  ImGui::PopFont();
  record(ctx, "molecule.name");
  tooltip(ctx, ((m.folder.empty() ? "" : m.folder + "\n") + m.format).c_str());
  if (!m.title.empty()) {
    muted_text(ctx, fitted_text(m.title, width));
    tooltip(ctx, m.title.c_str());
  }
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(m.summary.c_str());
  ImGui::PopTextWrapPos();
  record(ctx, "molecule.summary");
  selection(ctx);
  notes(ctx);
}

}  // namespace alphascope
