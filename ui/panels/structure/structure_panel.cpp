// SPDX-License-Identifier: GPL-3.0-or-later
// The page Structure: a tree of cavities, channels, chains, residues and ligands at the left, and
// the sequences at the right. A click selects, here and in the picture.
#include <imgui.h>

#include <optional>
#include <string>
#include <variant>

#include "core/document/reference/reference.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/store.hpp"
#include "core/molecule/molecule.hpp"
#include "ui/panels/panel.hpp"
#include "ui/panels/structure/structure_page.hpp"
#include "ui/panels/structure/structure_state.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {

std::string count_text(std::size_t n) {
  return with_separators(static_cast<long long>(n));
}

namespace {

constexpr float kTreeWidth = 250;  // pixels at scale 1

std::optional<std::size_t> row_in_picture(const StructurePage& page) {
  const auto& hovered = page.ctx.state.hovered;
  if (!hovered) return std::nullopt;
  const auto* const atom = std::get_if<AtomRef>(&*hovered);
  if (atom == nullptr) return std::nullopt;
  const auto place = find_atom(page.atoms.molecule(), {atom->atom, atom->copy});
  return place ? page.rows.row_of(static_cast<std::uint32_t>(*place)) : std::nullopt;
}

void draw_structure(PanelContext& ctx, StructureState& memory) {
  if (!ctx.state.has_molecule()) {
    muted_wrapped(ctx, "Open a molecule: its chains, residues and ligands appear here.");
    return record(ctx, "structure.waiting");
  }
  const Derived<StructureRows> rows = ctx.store.want(structure_rows(), ctx.inputs);
  if (!rows.ready() || !ctx.inputs.atoms) {  // else they may be rows of other atoms
    muted_wrapped(ctx, rows.why.empty() ? "The residues are being listed." : rows.why);
    return record(ctx, "structure.waiting");
  }
  if (memory.of != rows.value) {
    memory = {};
    memory.of = rows.value;
  }
  follow_tree_of_cavities(ctx, memory);
  follow_tree_of_channels(ctx, memory);
  StructurePage page{ctx, memory, *rows.value, *ctx.inputs.atoms, {}, {}, 0};
  page.pointed = memory.hovered ? memory.hovered : row_in_picture(page);
  const float height = ImGui::GetContentRegionAvail().y;
  ImGui::BeginChild("structure.tree", {ctx.px(kTreeWidth), height});
  draw_tree(page);
  ImGui::EndChild();
  ImGui::SameLine(0, ctx.px(12));
  ImGui::BeginChild("structure.sequences", {0, height});
  draw_sequences(page);
  ImGui::EndChild();
  memory.hovered = page.hovered;
  memory.hovered_way = page.hovered_way;
  mark_hovered(page);
}

}  // namespace

std::unique_ptr<Panel> structure_panel() {
  return panel_of<StructureState>(draw_structure);
}

}  // namespace alphascope
