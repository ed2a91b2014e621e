// Voids and pockets of the complex on screen: a table that sorts and filters, what CASTp would say
// differently, and the chosen ones in the view.
#include <algorithm>
#include <cstdio>
#include <string>

#include "core/chart/chart.hpp"
#include "core/chart/readable_number.hpp"
#include "core/document/cavity_names.hpp"
#include "core/document/cavity_preset.hpp"
#include "core/document/cavity_results.hpp"
#include "core/document/store.hpp"
#include "ui/panels/format.hpp"
#include "ui/panels/number_field.hpp"
#include "ui/panels/panels.hpp"

namespace alphascope {
namespace {

enum Column { rank, kind, volume, exact_volume, area, mouths, mouth_area, residues, name };
constexpr int kColumns = 9;

// --- from the table to lines

void make_lines(CavityMemory& memory, const CavityTable& table, const BallReferences& atoms) {
  memory.lines.clear();
  for (std::size_t row = 0; row < table.size(); ++row) {
    const CavityMeasures& m = table.measure(row);
    CavityLine line;
    line.row = row;
    line.is_void = table.cavity(row).is_void();
    line.volume = m.volume_sa_angstrom3;
    line.area = m.area_sa_angstrom2;
    line.mouth_area = m.all_mouths().area_angstrom2;
    line.mouths = m.mouths.size();
    line.residues = lining_residue_count(atoms, table, row);
    line.sink = cavity_sink(atoms, table, row);
    memory.lines.push_back(std::move(line));
  }
}

// Names are long, and only those of lines in sight are needed, or all to sort by them.
const std::string& name_of(CavityMemory& memory, std::size_t row, const BallReferences& atoms) {
  std::string& text = memory.lines[row].name;
  if (text.empty()) text = cavity_name(atoms, *memory.table, row);
  return text;
}

void take_table(CavityMemory& memory, const std::shared_ptr<const CavityTable>& table,
                const BallReferences& atoms) {
  if (memory.table == table) return;
  memory.table = table;
  memory.exact = nullptr;
  make_lines(memory, *table, atoms);
  memory.order_is_old = memory.layers_are_old = true;
}

void take_exact(CavityMemory& memory, const std::shared_ptr<const ExactVolumes>& exact) {
  if (memory.exact == exact || exact->of.size() != memory.lines.size()) return;
  memory.exact = exact;
  for (CavityLine& line : memory.lines) {
    line.exact_volume = exact->of[memory.table->order[line.row]].volume_sa_angstrom3;
  }
  memory.order_is_old = true;
}

double sort_value(const CavityLine& line, int column) {
  switch (column) {
    case kind:
      return line.is_void ? 0 : 1;
    case volume:
      return line.volume;
    case exact_volume:
      return line.exact_volume;
    case area:
      return line.area;
    case mouths:
      return static_cast<double>(line.mouths);
    case mouth_area:
      return line.mouth_area;
    case residues:
      return static_cast<double>(line.residues);
    default:
      return static_cast<double>(line.row);
  }
}

void make_order(CavityMemory& memory, const BallReferences* atoms) {
  if (!std::exchange(memory.order_is_old, false)) return;
  memory.order.clear();
  for (const CavityLine& line : memory.lines) {
    const bool of_kind = memory.kind == 0 || (memory.kind == 1) == line.is_void;
    if (of_kind && line.volume >= memory.least_volume) memory.order.push_back(line.row);
  }
  if (memory.sort_column == name && atoms) {
    for (const std::size_t row : memory.order) name_of(memory, row, *atoms);
  }
  const auto before = [&](std::size_t a, std::size_t b) {
    const CavityLine &x = memory.lines[a], &y = memory.lines[b];
    if (memory.sort_column == name) return x.name < y.name;
    return sort_value(x, memory.sort_column) < sort_value(y, memory.sort_column);
  };
  if (memory.descending) {
    std::stable_sort(memory.order.begin(), memory.order.end(),
                     [&](std::size_t a, std::size_t b) { return before(b, a); });
  } else {
    std::stable_sort(memory.order.begin(), memory.order.end(), before);
  }
}

// --- what is chosen

bool is_chosen(const CavityMemory& memory, const CavityLine& line) {
  return std::find(memory.chosen.begin(), memory.chosen.end(), line.sink) != memory.chosen.end();
}

void choose(CavityMemory& memory, const CavityLine& line, bool add) {
  const auto at = std::find(memory.chosen.begin(), memory.chosen.end(), line.sink);
  const bool was = at != memory.chosen.end();
  if (add && was) {
    memory.chosen.erase(at);
  } else if (add) {
    memory.chosen.push_back(line.sink);
  } else {
    memory.chosen = {line.sink};
  }
  memory.layers_are_old = true;
}

// The atoms that line what is chosen become the selection, and the camera goes there.
void select_lining(PanelContext& ctx, const CavityMemory& memory, const BallReferences& atoms) {
  std::vector<Ref> refs;
  for (const CavityLine& line : memory.lines) {
    if (!is_chosen(memory, line)) continue;
    for (const BallIndex ball : memory.table->measure(line.row).lining) {
      if (refs.size() < Selection::kMostItems) refs.push_back(atoms.atom(ball));
    }
  }
  ctx.state.picked.items = RefSet(std::move(refs));
  if (!memory.chosen.empty()) ctx.state.requests.zoom_to_selection = true;
}

ChartColour colour_of(std::size_t row) {
  return chart_colour(row);
}

std::shared_ptr<const Layer> layer_of(const CavityTable& table, const CavityLine& line,
                                      std::uint64_t key) {
  auto layer = std::make_shared<Layer>();
  layer->id = "cavities." + std::to_string(line.row);
  layer->key = key;
  layer->balls = table.ground->balls;
  const Cavity& cavity = table.cavity(line.row);
  const Incidence& incidence = table.ground->incidence;
  const auto& cavity_of = table.found.cavity_of_tetrahedron;
  const std::uint32_t own = table.order[line.row];
  layer->body = true;
  for (const std::uint32_t t : cavity.tetrahedra) {
    for (const std::uint32_t f : incidence.triangles_of_tetrahedron[t]) {
      const auto [a, b] = incidence.tetrahedra_of_triangle[f];
      const bool inside = b != Incidence::kOutside && cavity_of[a] == own && cavity_of[b] == own;
      if (!inside && layer->triangles.size() < Layer::kMostSimplices) {
        layer->triangles.push_back(incidence.triangles[f]);
      }
    }
  }
  const ChartColour c = colour_of(line.row);
  layer->colour = {static_cast<float>(c.r) / 255, static_cast<float>(c.g) / 255,
                   static_cast<float>(c.b) / 255, 1};
  return layer;
}

// The rims of its mouths: edges of one mouth triangle only.
std::shared_ptr<const Layer> rims_of(const CavityTable& table, const CavityLine& line,
                                     const Colour& colour, std::uint64_t key) {
  auto layer = std::make_shared<Layer>();
  layer->id = "cavities.mouths." + std::to_string(line.row);
  layer->key = key;
  layer->balls = table.ground->balls;
  const Incidence& incidence = table.ground->incidence;
  for (const Mouth& mouth : table.cavity(line.row).mouths) {
    std::vector<std::uint32_t> edges;
    for (const std::uint32_t f : mouth.triangles) {
      edges.insert(edges.end(), incidence.edges_of_triangle[f].begin(),
                   incidence.edges_of_triangle[f].end());
    }
    std::sort(edges.begin(), edges.end());
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const bool again =
          (k > 0 && edges[k] == edges[k - 1]) || (k + 1 < edges.size() && edges[k] == edges[k + 1]);
      if (!again && layer->edges.size() < Layer::kMostSimplices) {
        layer->edges.push_back(incidence.edges[edges[k]]);
      }
    }
  }
  layer->colour = colour;
  return layer;
}

std::string lining_text(const CavityMemory& memory, const BallReferences& atoms) {
  std::string text;
  for (const CavityLine& line : memory.lines) {
    if (!is_chosen(memory, line)) continue;
    for (const LiningResidue& residue : lining_residues(atoms, *memory.table, line.row)) {
      text += (text.empty() ? "" : ", ") + residue.address;
    }
  }
  return text;
}

void show_chosen(PanelContext& ctx, CavityMemory& memory) {
  const bool other_theme = std::exchange(memory.theme, ctx.state.theme) != ctx.state.theme;
  if (std::exchange(memory.layers_are_old, false) || other_theme) {
    static std::uint64_t key = 0;  // another number for each set of layers
    ++key;
    memory.layers.clear();
    memory.lining = lining_text(memory, *ctx.state.references);
    for (const CavityLine& line : memory.lines) {
      if (!is_chosen(memory, line)) continue;
      memory.layers.push_back(layer_of(*memory.table, line, key));
      memory.layers.push_back(rims_of(*memory.table, line, ctx.palette.text, key));
    }
  }
  for (const auto& layer : memory.layers) ctx.state.layers.push_back(layer);
}

// --- what is drawn

// Å³ or Å².
std::string measure_text(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.2f", value);
  return separated_number(text);
}

void totals_line(PanelContext& ctx, const CavityTable& table) {
  const auto kind_text = [&](bool voids, std::size_t number, const char* one) {
    return with_separators(static_cast<long long>(number)) + " " + one + (number == 1 ? "" : "s") +
           " " + measure_text(table.volume_sa_angstrom3(voids)) + " Å³";
  };
  ImGui::AlignTextToFramePadding();
  strong_text(ctx, kind_text(true, table.voids, "void"));
  ImGui::SameLine(0, ctx.px(14));
  ImGui::AlignTextToFramePadding();
  strong_text(ctx, kind_text(false, table.pockets, "pocket"));
  ImGui::SameLine(0, ctx.px(14));
  ImGui::AlignTextToFramePadding();
  muted_text(ctx, with_separators(static_cast<long long>(table.mouths)) + " mouths");
  record(ctx, "cavities.totals");
}

void use_preset(PanelContext& ctx) {
  use_cavity_preset(ctx.state.open, ctx.state.compute, ctx.state.molecule.has_file_radii);
}

void comparable_line(PanelContext& ctx) {
  RadiiSet radii = ctx.state.references->prepared().report.radii;
  const std::vector<std::string> differences =
      differences_from_castp(ctx.state.open.balls, radii, ctx.state.compute);
  ImGui::SameLine(0, ctx.px(18));
  if (differences.empty()) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextColored(to_imgui(ctx.palette.success), "comparable with CASTp");
    record(ctx, "cavities.comparable");
    return;
  }
  if (button(ctx, "cavities.preset", "Use CASTp's choices")) use_preset(ctx);
  tooltip(ctx,
          "Radii of CASTp, solvent radius 1.4 Å, α = 0; hydrogens, waters, ions and ligands are no "
          "part of the body. Undo brings back what was.");
  std::string why = "Chosen otherwise than CASTp does: ";
  for (std::size_t k = 0; k < differences.size(); ++k) why += (k ? "; " : "") + differences[k];
  ImGui::SameLine(0, ctx.px(8));
  ImGui::AlignTextToFramePadding();
  ImGui::TextColored(to_imgui(ctx.palette.warning), "not comparable with CASTp");
  record(ctx, "cavities.comparable");
  tooltip(ctx, (why + ".").c_str());
}

// What lines the chosen ones, or what to do.
std::string line_text(const CavityMemory& memory) {
  if (!memory.lining.empty()) return "lined by " + memory.lining;
  if (memory.order.size() < memory.lines.size()) {
    return with_separators(static_cast<long long>(memory.order.size())) + " of " +
           with_separators(static_cast<long long>(memory.lines.size())) + " shown";
  }
  return "Click a line to see its cavity, Ctrl+click for several.";
}

void filter_line(PanelContext& ctx, CavityMemory& memory) {
  const int kind_before = memory.kind;
  choice(ctx, "cavities.kind", {"all", "voids", "pockets"}, memory.kind, ctx.px(180));
  ImGui::SameLine(0, ctx.px(14));
  bool large = memory.least_volume > 0;
  if (checkbox(ctx, "cavities.large", "1 Å³ and more", large)) {
    memory.least_volume = large ? 1 : 0;
    memory.order_is_old = true;
  }
  tooltip(ctx, "Smaller ones are hardly more than the error of coordinates and radii.");
  if (memory.kind != kind_before) memory.order_is_old = true;
  ImGui::SameLine(0, ctx.px(14));
  ImGui::AlignTextToFramePadding();
  const std::string text = line_text(memory);
  muted_text(ctx, fitted_text(text, ImGui::GetContentRegionAvail().x));
  record(ctx, "cavities.lining");
  if (!memory.lining.empty()) tooltip(ctx, text.c_str());
}

void heading(PanelContext& ctx) {
  constexpr auto kNumber =
      ImGuiTableColumnFlags_WidthFixed | ImGuiTableColumnFlags_PreferSortDescending;
  const auto column = [&](const char* title, float width, ImGuiTableColumnFlags flags) {
    ImGui::TableSetupColumn(title, flags, ctx.px(width));
  };
  ImGui::TableSetupScrollFreeze(0, 1);
  column("#", 44, ImGuiTableColumnFlags_WidthFixed | ImGuiTableColumnFlags_DefaultSort);
  column("kind", 64, ImGuiTableColumnFlags_WidthFixed);
  column("volume Å³", 84, kNumber);
  column("exact Å³", 84, kNumber);
  column("area Å²", 76, kNumber);
  column("mouths", 64, kNumber);
  column("mouth Å²", 76, kNumber);
  column("residues", 72, kNumber);
  ImGui::TableSetupColumn("name: atoms of the deepest point", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableHeadersRow();
}

void take_sorting(CavityMemory& memory) {
  ImGuiTableSortSpecs* specs = ImGui::TableGetSortSpecs();
  if (!specs || !specs->SpecsDirty || specs->SpecsCount == 0) return;
  memory.sort_column = specs->Specs[0].ColumnIndex;
  memory.descending = specs->Specs[0].SortDirection == ImGuiSortDirection_Descending;
  memory.order_is_old = true;
  specs->SpecsDirty = false;
}

void number_cell(const std::string& text) {
  ImGui::TableNextColumn();
  const float right = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, right));
  ImGui::TextUnformatted(text.c_str());
}

// Exact volumes that differ are marked: CASTp's sum is not the volume of a pocket through whose
// mouth a ball pokes.
std::string exact_text_of(const CavityLine& line) {
  if (line.exact_volume < 0) return "…";
  const bool doubtful = is_doubtful(line.volume, line.exact_volume);
  return measure_text(line.exact_volume) + (doubtful ? " *" : "  ");
}

// The colour of its surface in the view, before the word: as text it would be hard to read.
void swatch(PanelContext& ctx, std::size_t row) {
  const ChartColour c = colour_of(row);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float side = ctx.px(9), top = corner.y + (ImGui::GetTextLineHeight() - side) / 2;
  ImGui::GetWindowDrawList()->AddRectFilled({corner.x, top}, {corner.x + side, top + side},
                                            IM_COL32(c.r, c.g, c.b, 255));
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + side + ctx.px(6));
}

// True when it was clicked.
bool draw_line(PanelContext& ctx, const CavityMemory& memory, const CavityLine& line) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushID(static_cast<int>(line.row));
  const bool clicked =
      ImGui::Selectable(std::to_string(line.row + 1).c_str(), is_chosen(memory, line),
                        ImGuiSelectableFlags_SpanAllColumns);
  record(ctx, ("cavities.row." + std::to_string(line.row + 1)).c_str());
  ImGui::PopID();
  ImGui::TableNextColumn();
  swatch(ctx, line.row);
  ImGui::TextUnformatted(line.is_void ? "void" : "pocket");
  number_cell(measure_text(line.volume));
  number_cell(exact_text_of(line));
  number_cell(measure_text(line.area));
  number_cell(std::to_string(line.mouths));
  number_cell(line.mouths == 0 ? "–" : measure_text(line.mouth_area));
  number_cell(std::to_string(line.residues));
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(fitted_text(line.name, ImGui::GetContentRegionAvail().x).c_str());
  return clicked;
}

// `atoms`: null while the lines are not of the picture; then a click does nothing.
void table_of_lines(PanelContext& ctx, CavityMemory& memory, const BallReferences* atoms) {
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_Sortable | ImGuiTableFlags_ScrollY |
                                     ImGuiTableFlags_RowBg | ImGuiTableFlags_Resizable;
  if (!ImGui::BeginTable("cavities", kColumns, kFlags, {0, 0})) return;
  heading(ctx);
  take_sorting(memory);
  make_order(memory, atoms);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(memory.order.size()));
  const CavityLine* clicked = nullptr;
  while (clipper.Step()) {
    for (int n = clipper.DisplayStart; n < clipper.DisplayEnd; ++n) {
      const CavityLine& line = memory.lines[memory.order[static_cast<std::size_t>(n)]];
      if (atoms) name_of(memory, line.row, *atoms);
      if (draw_line(ctx, memory, line)) clicked = &line;
    }
  }
  ImGui::EndTable();
  if (!clicked || !atoms) return;
  choose(memory, *clicked, ImGui::GetIO().KeyCtrl);
  select_lining(ctx, memory, *atoms);
}

// Why there is no table yet.
std::string waiting_text(const PanelContext& ctx, const Derived<CavityTable>& table) {
  if (!ctx.state.molecule.loaded) return "Open a molecule: its cavities appear here.";
  if (table.state == DerivedState::no_room || table.state == DerivedState::failed) {
    return "There is no table of cavities. " + table.why;
  }
  return "Cavities appear here when the triangulation of all balls is there.";
}

}  // namespace

void draw_cavities_panel(PanelContext& ctx) {
  CavityMemory& memory = ctx.state.memory.cavities;
  if (memory.molecule != ctx.state.molecule.sha256) {
    memory = {};
    memory.molecule = ctx.state.molecule.sha256;
  }
  const Derived<CavityTable> table = ctx.store.want(cavity_table(), ctx.inputs);
  const auto& atoms = ctx.state.references;
  // References and layers are of the balls on screen: a table of others has other indices.
  const bool fits = table.value && atoms && ctx.inputs.balls == table.value->ground->balls;
  if (fits) take_table(memory, table.value, *atoms);
  const bool current = fits && !table.stale();
  if (current) {
    const Derived<ExactVolumes> exact = ctx.store.want(cavity_volumes(), ctx.inputs);
    if (exact.ready()) take_exact(memory, exact.value);
  }
  if (!memory.table || !atoms) {
    muted_wrapped(ctx, waiting_text(ctx, table));
    record(ctx, "cavities.waiting");
    return;
  }
  // What is no longer, or not yet, of the picture is grey.
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, current ? 1.0f : 0.55f);
  totals_line(ctx, *memory.table);
  comparable_line(ctx);
  filter_line(ctx, memory);
  table_of_lines(ctx, memory, current ? atoms.get() : nullptr);
  ImGui::PopStyleVar();
  if (current) show_chosen(ctx, memory);
}

}  // namespace alphascope
