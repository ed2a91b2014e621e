// SPDX-License-Identifier: GPL-3.0-or-later
// Selects residues by the mouse, and marks the one under it.
#include <imgui.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/document/commands/commands.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/store/answer.hpp"
#include "core/molecule/molecule.hpp"
#include "ui/layer.hpp"
#include "ui/panels/frame/context_state.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/structure/structure_page.hpp"
#include "ui/panels/structure/structure_state.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

void add_atoms(const StructurePage& page, std::size_t row, std::vector<Ref>& refs) {
  const ResidueRow& r = page.rows.residues[row];
  for (std::uint32_t i = r.first; i < r.end && refs.size() < Selection::kMostItems; ++i) {
    refs.emplace_back(page.atoms.atom_of_molecule(i));
  }
}

// An expression for the atoms of a branch. `first`: one for its first atom.
std::string expression_of_branch(const ResidueBranch& branch, const std::string& first) {
  switch (branch.kind) {
    case ResidueKind::ligand:
      return "ligand";
    case ResidueKind::ion:
      return "ion";
    case ResidueKind::water:
      return "water";
    case ResidueKind::polymer:
      return "polymer and bychain (" + first + ")";
    case ResidueKind::dummy:
      break;
  }
  return "byres (" + first + ")";
}

// Whether all atoms of the rows [begin, end) are selected that are balls; without balls, all atoms.
// Commands select balls only.
bool is_wholly_selected(const StructurePage& page, std::size_t begin, std::size_t end) {
  const RefSet& items = page.ctx.state.settings.selection.items;
  bool any_ball = false, all_balls = true, all_atoms = !items.empty();
  for (std::size_t row = begin; row < end && all_balls; ++row) {
    const ResidueRow& r = page.rows.residues[row];
    for (std::uint32_t i = r.first; i < r.end && all_balls; ++i) {
      const AtomRef atom = page.atoms.atom_of_molecule(i);
      const bool in = items.contains(atom);
      all_atoms &= in;
      if (!page.atoms.ball(atom)) continue;
      any_ball = true;
      all_balls = in;
    }
  }
  return any_ball ? all_balls : all_atoms;
}

// Selects rows [begin, end). With Shift, these are all from the last clicked one. With Ctrl they
// are added; without Shift they are removed if they were wholly selected.
void select(StructurePage& page, std::size_t begin, std::size_t end) {
  Selection& selection = page.ctx.state.settings.selection;
  const ImGuiIO& io = ImGui::GetIO();
  if (io.KeyShift && page.memory.anchor < page.rows.residues.size()) {
    begin = std::min(begin, page.memory.anchor);
    end = std::max(end, page.memory.anchor + 1);
  } else {
    page.memory.anchor = begin;
  }
  std::vector<Ref> refs;
  for (std::size_t row = begin; row < end; ++row) add_atoms(page, row, refs);
  if (refs.size() >= Selection::kMostItems) {
    page.ctx.state.notice = "The first " + count_text(Selection::kMostItems) +
                            " atoms are selected. More would slow down the picture.";
  }
  if (!io.KeyCtrl) {
    selection.items = RefSet(std::move(refs));
    return;
  }
  const bool off = !io.KeyShift && is_wholly_selected(page, begin, end);
  if (!off) {
    selection.items = selection.items.with(refs);
    return;
  }
  std::vector<Ref> kept;
  const RefSet out(std::move(refs));
  for (const Ref& item : selection.items.items()) {
    if (!out.contains(item)) kept.push_back(item);
  }
  selection.items = RefSet(std::move(kept));
}

}  // namespace

bool is_selected(const StructurePage& page, std::size_t row) {
  const RefSet& items = page.ctx.state.settings.selection.items;
  if (items.empty()) return false;
  const ResidueRow& r = page.rows.residues[row];
  for (std::uint32_t i = r.first; i < r.end; ++i) {
    if (items.contains(page.atoms.atom_of_molecule(i))) return true;
  }
  return false;
}

void take_mouse(StructurePage& page, std::size_t begin, std::size_t end, bool clicked) {
  if (clicked) select(page, begin, end);
  if (!ImGui::IsItemHovered()) return;
  page.hovered = begin;
  if (ImGui::IsMouseDoubleClicked(0)) {
    if (const CommandSpec* const zoom = page.ctx.commands.find("view.zoom_to_selection")) {
      run_command(page.ctx, *zoom, {});
    }
  }
  if (!ImGui::IsMouseReleased(1)) return;
  ContextState& menu = page.ctx.state.context;
  menu.opens = true;
  menu.what = page.atoms.atom_of_molecule(page.rows.residues[begin].first);
  const std::string first = expression_of(page.atoms.molecule(), *menu.what);
  menu.title = residue_title(page.atoms.molecule(), page.rows.residues[begin]);
  menu.atoms = "byres (" + first + ")";
  if (end == begin + 1) return;
  const auto branch = std::find_if(page.rows.branches.begin(), page.rows.branches.end(),
                                   [&](const ResidueBranch& b) { return b.begin == begin; });
  menu.title = branch->title;
  menu.atoms = expression_of_branch(*branch, first);
}

void mark_hovered(StructurePage& page) {
  StructureState& m = page.memory;
  const auto balls = page.ctx.state.result ? page.ctx.state.result->balls : nullptr;
  if (!page.hovered || !balls) return;
  if (m.marked != page.hovered || m.mark == nullptr || m.mark->balls != balls) {
    auto layer = std::make_shared<Layer>();
    layer->id = "structure.hovered";
    layer->key = *page.hovered + 1;
    layer->balls = balls;
    layer->colour = page.ctx.palette.accent;
    layer->fades_rest = false;
    layer->in_pictures = false;
    const ResidueRow& row = page.rows.residues[*page.hovered];
    for (std::uint32_t i = row.first; i < row.end; ++i) {
      const auto ball = page.atoms.ball(page.atoms.atom_of_molecule(i));
      if (ball) layer->vertices.push_back({*ball});
    }
    m.marked = page.hovered;
    m.mark = std::move(layer);
  }
  page.ctx.state.layers.push_back(m.mark);
}

}  // namespace alphascope
