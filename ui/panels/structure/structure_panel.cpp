// SPDX-License-Identifier: GPL-3.0-or-later
// The page Structure: a tree of chains, residues, ligands and cavities at the left, and the
// sequences at the right. A click selects, here and in the picture. Only lines in sight are drawn.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/document/cavities/cavity_results.hpp"
#include "core/document/commands/commands.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/store/answer.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/store.hpp"
#include "core/document/structure/structure_rows.hpp"
#include "core/document/tables/cell_value.hpp"
#include "core/molecule/molecule.hpp"
#include "core/selection/prepare_balls.hpp"
#include "ui/layer.hpp"
#include "ui/number_text.hpp"
#include "ui/panels/cavities/cavity_page.hpp"
#include "ui/panels/cavities/cavity_parts.hpp"
#include "ui/panels/cavities/cavity_state.hpp"
#include "ui/panels/frame/context_state.hpp"
#include "ui/panels/panel.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/structure/structure_state.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/style.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

constexpr const char* kPage = "structure";
constexpr float kTreeWidth = 250;  // pixels at scale 1

std::string count_text(std::size_t n) {
  return with_separators(static_cast<long long>(n));
}

// The rows and what the mouse does with them in this frame.
struct Page {
  PanelContext& ctx;
  StructureState& memory;
  const StructureRows& rows;
  const BallReferences& atoms;
  std::optional<std::size_t> pointed;  // row under the mouse, here or in the picture
  std::optional<std::size_t> hovered;  // row under the mouse on this page

  const Molecule& molecule() const { return atoms.molecule(); }
};

// --- selecting

void add_atoms(const Page& page, std::size_t row, std::vector<Ref>& refs) {
  const ResidueRow& r = page.rows.residues[row];
  for (std::uint32_t i = r.first; i < r.end && refs.size() < Selection::kMostItems; ++i) {
    refs.emplace_back(page.atoms.atom_of_molecule(i));
  }
}

bool is_selected(const Page& page, std::size_t row) {
  const RefSet& items = page.ctx.state.settings.selection.items;
  if (items.empty()) return false;
  return items.contains(page.atoms.atom_of_molecule(page.rows.residues[row].first));
}

// Selects rows [begin, end). With Ctrl they are added; with Shift all from the last clicked one.
void select(Page& page, std::size_t begin, std::size_t end) {
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
    selection.cavities = {};
    return;
  }
  const bool off = end == begin + 1 && is_selected(page, begin);
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

// Clicks on the last item, which stands for these rows.
void handle_mouse(Page& page, std::size_t begin, std::size_t end, bool clicked) {
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
  menu.title = residue_title(page.molecule(), page.rows.residues[begin]);
}

// --- tree

constexpr const char* kCavities = "Cavities";

// A line of the tree: a branch, a residue of it, the branch of cavities, or a cavity.
struct TreeLine {
  enum class Kind : std::uint8_t { branch, residue, cavities, cavity } kind = Kind::branch;
  std::size_t branch = 0, row = 0;
};

// Null while the table of cavities is not known, or its branch is closed.
const CavityLines* open_cavities(const Page& page) {
  const CavityPage* const cavities = page.ctx.state.cavities.page.get();
  const bool open = page.memory.open.contains(kCavities);
  return open && cavities != nullptr ? cavities->rows.lines.get() : nullptr;
}

// Lines of the branch of cavities, which comes first.
std::size_t lines_of_cavities(const Page& page) {
  const CavityLines* const cavities = open_cavities(page);
  return 1 + (cavities != nullptr ? cavities->of.size() : 0);
}

// The nth visible line. Branches are few; the residues of open ones are not listed one by one.
TreeLine line_at(const Page& page, std::size_t n) {
  if (n == 0) return {TreeLine::Kind::cavities, 0, 0};
  if (n < lines_of_cavities(page)) return {TreeLine::Kind::cavity, 0, n - 1};
  n -= lines_of_cavities(page);
  for (std::size_t b = 0; b < page.rows.branches.size(); ++b) {
    if (n == 0) return {TreeLine::Kind::branch, b, 0};
    --n;
    const ResidueBranch& branch = page.rows.branches[b];
    if (!page.memory.open.contains(branch.title)) continue;
    if (n < branch.size()) return {TreeLine::Kind::residue, b, branch.begin + n};
    n -= branch.size();
  }
  return {TreeLine::Kind::cavities, 0, 0};
}

// The index of a row's line; empty if its branch is closed.
std::optional<std::size_t> line_of(const Page& page, std::size_t row) {
  std::size_t n = lines_of_cavities(page);
  for (const ResidueBranch& branch : page.rows.branches) {
    ++n;
    const bool open = page.memory.open.contains(branch.title);
    if (row >= branch.begin && row < branch.end) {
      return open ? std::optional(n + row - branch.begin) : std::nullopt;
    }
    if (open) n += branch.size();
  }
  return std::nullopt;
}

void cavities_line(Page& page) {
  auto& open = page.memory.open;
  const bool is_open = open.contains(kCavities);
  ImGui::SetNextItemOpen(is_open);
  const CavityLines* const lines = open_cavities(page);
  const std::string text = is_open && lines == nullptr ? "Cavities are being found"
                           : lines == nullptr
                               ? kCavities
                               : std::string(kCavities) + "  " + count_text(lines->of.size());
  const bool now = ImGui::TreeNodeEx(
      "##cavities", ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_NoTreePushOnOpen, "%s",
      text.c_str());
  record(page.ctx, "structure.cavities");
  tooltip(page.ctx, "Voids and pockets of the complex on screen, as on the page Cavities.");
  if (now != is_open) now ? (void)open.insert(kCavities) : (void)open.erase(kCavities);
}

void cavity_line(Page& page, std::size_t row) {
  CavityPage& cavities = *page.ctx.state.cavities.page;
  const CavityLine& line = cavities.rows.lines->of[row];
  const bool chosen =
      std::binary_search(cavities.selected_rows.begin(), cavities.selected_rows.end(), row);
  const std::string text = std::to_string(row + 1) + (line.is_void ? "  void  " : "  pocket  ") +
                           measure_text(line.volume_sa_angstrom3) + " Å³";
  ImGui::Indent(page.ctx.px(22));
  if (ImGui::Selectable((text + "##cavity" + std::to_string(row)).c_str(), chosen)) {
    const ImGuiIO& io = ImGui::GetIO();
    select_cavity(page.ctx, cavities, row,
                  io.KeyShift  ? HowSelected::range
                  : io.KeyCtrl ? HowSelected::toggled
                               : HowSelected::alone);
  }
  record(page.ctx, ("structure.cavity." + std::to_string(row + 1)).c_str());
  ImGui::Unindent(page.ctx.px(22));
}

void branch_line(Page& page, std::size_t b) {
  const ResidueBranch& branch = page.rows.branches[b];
  auto& open = page.memory.open;
  const bool is_open = open.contains(branch.title);
  ImGui::SetNextItemOpen(is_open);
  const std::string text = branch.title + "  " + count_text(branch.size());
  const bool now =
      ImGui::TreeNodeEx(("##branch" + std::to_string(b)).c_str(),
                        ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_NoTreePushOnOpen |
                            ImGuiTreeNodeFlags_OpenOnArrow,
                        "%s", text.c_str());
  const bool toggled = ImGui::IsItemToggledOpen();
  record(page.ctx, ("structure.branch." + std::to_string(b + 1)).c_str());
  handle_mouse(page, branch.begin, branch.end, ImGui::IsItemClicked() && !toggled);
  tooltip(page.ctx, "A click selects it, a click on the arrow opens it.");
  if (now == is_open) return;
  now ? (void)open.insert(branch.title) : (void)open.erase(branch.title);
}

void residue_line(Page& page, std::size_t row) {
  const std::string title = residue_title(page.molecule(), page.rows.residues[row]);
  ImGui::Indent(page.ctx.px(22));
  const bool marked = is_selected(page, row) || page.pointed == row;
  const bool clicked = ImGui::Selectable((title + "##" + std::to_string(row)).c_str(), marked);
  record(page.ctx, ("structure.residue." + std::to_string(row + 1)).c_str());
  handle_mouse(page, row, row + 1, clicked);
  ImGui::Unindent(page.ctx.px(22));
}

void draw_tree(Page& page) {
  std::size_t lines = page.rows.branches.size();
  for (const ResidueBranch& branch : page.rows.branches) {
    if (page.memory.open.contains(branch.title)) lines += branch.size();
  }
  lines += lines_of_cavities(page);
  const float height = ImGui::GetTextLineHeightWithSpacing();
  // A residue under the mouse in the picture comes into sight.
  if (page.pointed && page.pointed != page.memory.hovered && page.pointed != page.memory.scrolled) {
    if (const auto line = line_of(page, *page.pointed)) {
      const float at = static_cast<float>(*line) * height;
      const float top = ImGui::GetScrollY(), seen = ImGui::GetWindowHeight();
      if (at < top || at + height > top + seen) {
        ImGui::SetScrollY(std::max(0.0F, at - seen / 2));
      }
    }
  }
  page.memory.scrolled = page.pointed;
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(std::min<std::size_t>(lines, 1u << 30)), height);
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const TreeLine line = line_at(page, static_cast<std::size_t>(i));
      switch (line.kind) {
        case TreeLine::Kind::branch:
          branch_line(page, line.branch);
          break;
        case TreeLine::Kind::residue:
          residue_line(page, line.row);
          break;
        case TreeLine::Kind::cavities:
          cavities_line(page);
          break;
        case TreeLine::Kind::cavity:
          cavity_line(page, line.row);
          break;
      }
    }
  }
}

// --- sequences

Colour secondary_colour(const PanelContext& ctx, SecondaryStructure kind) {
  if (is_helix(kind)) return {0.84F, 0.37F, 0, 1};
  if (kind == SecondaryStructure::strand) return {0, 0.45F, 0.70F, 1};
  return ctx.palette.text_muted;
}

// Letters of one chain that stand in one line.
void sequence_line(Page& page, const ResidueBranch& branch, std::size_t begin, std::size_t end,
                   ImVec2 cell) {
  PanelContext& ctx = page.ctx;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ResidueRow& first = page.rows.residues[begin];
  const std::string number = std::to_string(page.molecule().atoms[first.first].residue_number);
  const std::string label = (begin == branch.begin ? branch.title + "  " : "") + number;
  const float label_width = ctx.px(110);
  ImGui::PushFont(ctx.fonts.small);
  const float width = ImGui::CalcTextSize(label.c_str()).x;
  draw->AddText({corner.x + label_width - ctx.px(8) - width, corner.y},
                to_u32(ctx.palette.text_muted), label.c_str());
  ImGui::PopFont();
  const float left = corner.x + label_width;
  const auto letters = static_cast<float>(end - begin);
  ImGui::SetCursorScreenPos({left, corner.y});
  const bool clicked = ImGui::InvisibleButton(("##line" + std::to_string(begin)).c_str(),
                                              {letters * cell.x, cell.y});
  record(ctx, ("structure.sequence." + std::to_string(begin + 1)).c_str());
  if (ImGui::IsItemHovered() || clicked || ImGui::IsItemClicked(1)) {
    const float at = (ImGui::GetMousePos().x - left) / cell.x;
    const auto letter = static_cast<std::size_t>(std::clamp(at, 0.0F, letters - 1));
    const std::size_t row = begin + letter;
    handle_mouse(page, row, row + 1, clicked);
    if (ImGui::IsItemHovered()) {
      ImGui::SetTooltip("%s, chain %s",
                        residue_title(page.molecule(), page.rows.residues[row]).c_str(),
                        branch.title.c_str());
    }
  }
  ImGui::PushFont(ctx.fonts.mono);
  for (std::size_t row = begin; row < end; ++row) {
    const ResidueRow& residue = page.rows.residues[row];
    const ImVec2 at{left + static_cast<float>(row - begin) * cell.x, corner.y};
    const ImVec2 to{at.x + cell.x, at.y + cell.y};
    const Colour colour = secondary_colour(ctx, residue.secondary);
    const bool coil =
        !is_helix(residue.secondary) && residue.secondary != SecondaryStructure::strand;
    if (is_selected(page, row)) {
      draw->AddRectFilled(at, to, to_u32(ctx.palette.selected, 0.55F));
    } else if (!coil) {
      draw->AddRectFilled({at.x, at.y + cell.y * 0.86F}, {to.x, to.y}, to_u32(colour));
    }
    if (page.pointed == row) draw->AddRect(at, to, to_u32(ctx.palette.accent), 2);
    const char letter[2] = {residue.letter, 0};
    const float inset = (cell.x - ImGui::CalcTextSize(letter).x) / 2;
    draw->AddText({at.x + inset, at.y}, to_u32(ctx.palette.text), letter);
  }
  ImGui::PopFont();
}

void draw_sequences(Page& page) {
  ImGui::PushFont(page.ctx.fonts.mono);
  const ImVec2 cell{ImGui::CalcTextSize("W").x + page.ctx.px(2),
                    ImGui::GetTextLineHeight() + page.ctx.px(2)};
  ImGui::PopFont();
  const float room = ImGui::GetContentRegionAvail().x - page.ctx.px(118);
  constexpr std::size_t kTens = 10;
  const auto fitting = static_cast<std::size_t>(std::max(1.0F, room / cell.x));
  const std::size_t each = fitting >= kTens ? fitting / kTens * kTens : fitting;
  std::vector<std::pair<std::size_t, std::size_t>> first_lines;  // branch and its first line
  std::size_t lines = 0;
  for (std::size_t b = 0; b < page.rows.branches.size(); ++b) {
    if (page.rows.branches[b].kind != ResidueKind::polymer) continue;
    first_lines.emplace_back(b, lines);
    lines += (page.rows.branches[b].size() + each - 1) / each;
  }
  if (lines == 0) return muted_wrapped(page.ctx, "There is no protein or nucleic acid.");
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(lines), cell.y + page.ctx.px(4));
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const auto line = static_cast<std::size_t>(i);
      const auto after =
          std::upper_bound(first_lines.begin(), first_lines.end(), line,
                           [](std::size_t l, const auto& f) { return l < f.second; });
      const auto& [b, first] = *(after - 1);
      const ResidueBranch& branch = page.rows.branches[b];
      const std::size_t begin = branch.begin + (line - first) * each;
      const float top = ImGui::GetCursorPosY();
      sequence_line(page, branch, begin, std::min(begin + each, branch.end), cell);
      ImGui::SetCursorPosY(top + cell.y + page.ctx.px(4));
    }
  }
}

// --- the residue under the mouse

std::optional<std::size_t> row_in_picture(const Page& page) {
  const auto& hovered = page.ctx.state.hovered;
  if (!hovered) return std::nullopt;
  const auto* const atom = std::get_if<AtomRef>(&*hovered);
  if (atom == nullptr) return std::nullopt;
  const auto place = find_atom(page.molecule(), {atom->atom, atom->copy});
  return place ? page.rows.row_of(static_cast<std::uint32_t>(*place)) : std::nullopt;
}

// Marks the balls of the residue in the picture.
void mark_hovered(Page& page) {
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

void draw_structure(PanelContext& ctx, StructureState& memory) {
  if (!ctx.state.has_molecule()) {
    muted_wrapped(ctx, "Open a molecule: its chains, residues and ligands appear here.");
    return record(ctx, "structure.waiting");
  }
  const Derived<StructureRows> rows = ctx.store.want(structure_rows(), ctx.inputs);
  if (!rows.value || !ctx.inputs.atoms) {
    muted_wrapped(ctx, rows.why.empty() ? "The residues are being listed." : rows.why);
    return record(ctx, "structure.waiting");
  }
  if (memory.of != rows.value) {
    memory = {};
    memory.of = rows.value;
  }
  if (memory.open.contains(kCavities)) {
    const bool current = follow_cavities(ctx).current;
    CavityPage& cavities = *ctx.state.cavities.page;
    if (cavities.rows.lines) draw_layers_of_cavities(ctx, cavities, current);
  }
  Page page{ctx, memory, *rows.value, *ctx.inputs.atoms, {}, {}};
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
  mark_hovered(page);
}

}  // namespace

std::unique_ptr<Panel> structure_panel() {
  return panel_of<StructureState>(draw_structure);
}

}  // namespace alphascope
