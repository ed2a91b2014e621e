// SPDX-License-Identifier: GPL-3.0-or-later
// The rows that choose which atoms become balls: kinds, hydrogens, alternatives, chains and an
// expression.
#include <imgui.h>

#include <algorithm>
#include <utility>

#include "core/document/commands/commands.hpp"
#include "core/document/settings/open_options.hpp"
#include "core/document/store/key.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/residue_kind.hpp"
#include "core/selection/ball_options.hpp"
#include "core/selection/contents.hpp"
#include "core/selection/selection_error.hpp"
#include "core/text/grouped_number.hpp"
#include "ui/panels/molecule/expression_state.hpp"
#include "ui/panels/molecule/molecule_state.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/view_info.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/key_focus.hpp"
#include "ui/widgets/style.hpp"

namespace alphascope {
namespace {

std::string number(std::size_t n) {
  return with_separators(static_cast<long long>(n));
}

void kind_toggle(PanelContext& ctx, const char* name, const char* label, bool& value,
                 std::size_t atoms, const char* help) {
  checkbox(ctx, name, label, value);
  const std::string count = atoms == 0 ? "None in this molecule."
                                       : number(atoms) + " atoms in this molecule, all models.";
  tooltip(ctx, (help + std::string("\n") + count).c_str());
}

void kinds(PanelContext& ctx) {
  BallOptions& c = ctx.state.settings.open.balls;
  const KindCounts& k = ctx.state.molecule.contents.kinds;
  row_label(ctx, "Keep");
  const float column = ImGui::GetCursorPosX() + ctx.px(96);
  kind_toggle(ctx, "molecule.polymers", "Polymers", c.polymers, of_kind(k, ResidueKind::polymer),
              "Proteins and nucleic acids, with their modified residues.");
  ImGui::SameLine(column);
  kind_toggle(ctx, "molecule.waters", "Waters", c.waters, of_kind(k, ResidueKind::water),
              "HOH, DOD, WAT, SOL, TIP3 …");
  row_label(ctx, "");
  kind_toggle(ctx, "molecule.ligands", "Ligands", c.ligands, of_kind(k, ResidueKind::ligand),
              "Residues that are not polymer, water, ion or dummy.");
  ImGui::SameLine(column);
  kind_toggle(ctx, "molecule.ions", "Ions", c.ions, of_kind(k, ResidueKind::ion),
              "Metal and halide atoms that are a residue of their own.");
  const std::size_t dummies = of_kind(k, ResidueKind::dummy);
  if (dummies == 0 && !c.dummies) return;
  row_label(ctx, "");
  kind_toggle(ctx, "molecule.dummies", "Dummy atoms", c.dummies, dummies,
              "Markers without matter (residue DUM), such as those of membrane planes.");
}

void hydrogens_and_altlocs(PanelContext& ctx) {
  BallOptions& c = ctx.state.settings.open.balls;
  const MoleculeContents& k = ctx.state.molecule.contents;
  row_label(ctx, "Hydrogens");
  int hydrogens = static_cast<int>(c.hydrogens);
  ImGui::BeginGroup();
  choice(ctx, "molecule.hydrogens", {"auto", "keep", "drop"}, hydrogens,
         ImGui::GetContentRegionAvail().x);
  ImGui::EndGroup();
  tooltip(
      ctx,
      ("auto: hydrogens are dropped if the radii set counts them in the radii of heavy atoms.\n" +
       number(k.hydrogens) + " in this molecule, all models.")
          .c_str());
  c.hydrogens = static_cast<HydrogenRule>(hydrogens);
  row_label(ctx, "Alternatives");
  int altlocs = static_cast<int>(c.altlocs);
  ImGui::BeginGroup();
  choice(ctx, "molecule.altlocs", {"best", "all"}, altlocs, ImGui::GetContentRegionAvail().x);
  ImGui::EndGroup();
  tooltip(ctx, ("Alternative locations of one atom. best: in each residue, the location with the "
                "highest occupancy, then the lowest B factor.\n" +
                number(k.with_altloc) + " atoms with alternative locations, all models.")
                   .c_str());
  c.altlocs = static_cast<AltlocRule>(altlocs);
}

// --- chains

bool is_off(const BallOptions& c, const std::string& chain) {
  return std::find(c.without_chains.begin(), c.without_chains.end(), chain) !=
         c.without_chains.end();
}

void switch_chain(BallOptions& c, const std::string& chain, bool on) {
  std::erase(c.without_chains, chain);
  if (!on) c.without_chains.push_back(chain);
}

void switch_all(ViewState& s, bool on, const std::string& but = {}, bool with_exception = false) {
  s.settings.open.balls.without_chains.clear();
  for (const ChainContents& chain : s.molecule.contents.chains) {
    const bool exception = with_exception && chain.name == but;
    if (!on && !exception) s.settings.open.balls.without_chains.push_back(chain.name);
  }
}

void chain_line(PanelContext& ctx, const ChainContents& chain, float width) {
  ViewState& s = ctx.state;
  bool on = !is_off(s.settings.open.balls, chain.name);
  const std::string id = "molecule.chain." + chain.name;
  if (checkbox(ctx, id.c_str(), chain.name.empty() ? "(no name)" : chain.name.c_str(), on)) {
    switch_chain(s.settings.open.balls, chain.name, on);
  }
  const std::string kinds = kinds_text(chain.kinds);
  tooltip(ctx, kinds.c_str());
  ImGui::SameLine(ctx.px(88));
  ImGui::AlignTextToFramePadding();
  muted_text(ctx, counted(chain.atoms, "atom", "atoms"));
  tooltip(ctx, kinds.c_str());
  ImGui::SameLine(width - ctx.px(52));
  if (button(ctx, ("molecule.only." + chain.name).c_str(), "only", {ctx.px(44), 0},
             ButtonKind::quiet)) {
    switch_all(s, false, chain.name, true);
  }
}

// Draws the lines in sight only, since an assembly can have thousands of chains.
void chain_lines(PanelContext& ctx, MoleculeState& memory) {
  const ViewState& s = ctx.state;
  const std::string& filter = memory.chain_filter;
  std::vector<const ChainContents*> shown;
  for (const ChainContents& chain : s.molecule.contents.chains) {
    if (filter.empty() || chain.name.find(filter) != std::string::npos) shown.push_back(&chain);
  }
  const float row = ImGui::GetFrameHeightWithSpacing();
  const float width = ctx.px(250);
  const float height = row * static_cast<float>(std::clamp<std::size_t>(shown.size(), 1, 10));
  ImGui::BeginChild("chains", {width, height});
  if (shown.empty()) muted_text(ctx, "No chain's name contains this text.");
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(shown.size()), row);
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      chain_line(ctx, *shown[static_cast<std::size_t>(i)], width);
    }
  }
  ImGui::EndChild();
}

void chain_popup(PanelContext& ctx, MoleculeState& memory) {
  ViewState& s = ctx.state;
  constexpr std::size_t kFilterFrom = 10;
  if (button(ctx, "molecule.chains.all", "All")) switch_all(s, true);
  ImGui::SameLine(0, ctx.px(4));
  if (button(ctx, "molecule.chains.none", "None")) switch_all(s, false);
  if (s.molecule.contents.chains.size() >= kFilterFrom) {
    ImGui::SameLine(0, ctx.px(8));
    ImGui::SetNextItemWidth(ctx.px(130));
    text_field(ctx, "molecule.chains.filter", memory.chain_filter, "name contains…");
  } else {
    memory.chain_filter.clear();
  }
  chain_lines(ctx, memory);
}

void chains(PanelContext& ctx, MoleculeState& memory) {
  const ViewState& s = ctx.state;
  const std::size_t all = s.molecule.contents.chains.size();
  const auto off = static_cast<std::size_t>(std::count_if(
      s.molecule.contents.chains.begin(), s.molecule.contents.chains.end(),
      [&](const ChainContents& chain) { return is_off(s.settings.open.balls, chain.name); }));
  row_label(ctx, "Chains");
  const std::string preview = all == 1 && off == 0 ? "the only one"
                              : off == 0           ? "all " + number(all)
                                                   : number(all - off) + " of " + number(all);
  if (!list_field(ctx, "molecule.chains", preview.c_str(), ImGuiComboFlags_HeightLargest)) return;
  chain_popup(ctx, memory);
  ImGui::EndCombo();
}

// --- expression

constexpr const char* kExpressionHelp =
    "Keeps only the atoms that match an expression. Enter applies it.\n\n"
    "chain A,B      resi 10-20,35      resn ALA,G*\n"
    "name CA,C?      element C,Zn      altloc A\n"
    "index 12,20-30      copy 2      b > 40      occupancy < 1\n"
    "protein  nucleic  polymer  backbone  sidechain\n"
    "water  ligand  ion  hydrogen  hetero\n"
    "within 5 of …      byres …      bychain …\n"
    "not …      … and …      … or …      ( … )\n\n"
    "chain A and not resn HEM\n"
    "byres within 5 of resn HEM\n"
    "name CA and (chain A or chain B)\n\n"
    "The switches above still apply: keep waters to select them.";

// Marks the column of the error at the lower edge of the field.
void mark_column(PanelContext& ctx, const std::string& text, std::size_t column) {
  const WidgetRect field = ctx.rects["molecule.expression"];
  const std::size_t before = std::min(column - 1, text.size());
  const float left = field.x0 + ImGui::GetStyle().FramePadding.x;
  const float x = left + ImGui::CalcTextSize(text.substr(0, before).c_str()).x;
  if (x > field.x1) return;  // the column is scrolled out of sight; the message names it
  ImGui::GetWindowDrawList()->AddRectFilled({x, field.y1 - ctx.px(3)},
                                            {std::min(x + ctx.px(8), field.x1), field.y1},
                                            to_u32(ctx.palette.error));
}

// Shows the error. Its line has room even without one, so that nothing moves.
void expression_message(PanelContext& ctx, bool pending) {
  const auto& fault = ctx.state.expression_error;
  ImGui::PushFont(ctx.fonts.small);
  const float top = ImGui::GetCursorPosY();
  if (fault) {
    ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(ctx.palette.error));
    ImGui::TextUnformatted(fitted_text(fault->what(), ImGui::GetContentRegionAvail().x).c_str());
    ImGui::PopStyleColor();
    record(ctx, "molecule.expression.error");
    tooltip(ctx, fault->what());
  } else if (pending) {
    muted_text(ctx, "Enter applies it.");
  }
  reserve_lines(top, 1);
  ImGui::PopFont();
}

void expression(PanelContext& ctx) {
  ViewState& s = ctx.state;
  ExpressionState& m = s.expression;
  // Another file is open, or an undo has changed the expression.
  if (s.settings.open.balls.selection != m.shown) {
    m.shown = m.typed = s.settings.open.balls.selection;
  }
  row_label(ctx, "Only", 30);
  const bool entered = text_field(ctx, "molecule.expression", m.typed, "chain A or ligand");
  if (ImGui::IsItemEdited()) s.expression_error.reset();
  const bool pending = m.typed != s.settings.open.balls.selection;
  if (entered) {
    s.expression_error.reset();
    s.settings.open.balls.selection = m.shown = m.typed;
    m.entered = true;
  } else if (std::exchange(m.entered, false) && s.expression_error) {
    type_into(ctx, "molecule.expression");  // so that the user can mend it
  }
  if (s.expression_error) mark_column(ctx, m.typed, s.expression_error->column());
  ImGui::SameLine(0, ctx.px(4));
  button(ctx, "molecule.expression.help", "?", {-1, 0}, ButtonKind::quiet);
  tooltip(ctx, kExpressionHelp);
  expression_message(ctx, pending);
}

}  // namespace

void draw_selection_rows(PanelContext& ctx, MoleculeState& memory) {
  kinds(ctx);
  hydrogens_and_altlocs(ctx);
  chains(ctx, memory);
  expression(ctx);
}

}  // namespace alphascope
