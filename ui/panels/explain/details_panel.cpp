// SPDX-License-Identifier: GPL-3.0-or-later
// The page “Details”: facts on the selected atom or simplex, a list of the simplices around it, and
// measured distances and angles.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "core/document/explain/explanation_results.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/store/answer.hpp"
#include "core/molecule/element.hpp"
#include "core/molecule/molecule.hpp"
#include "core/selection/atom_address.hpp"
#include "ui/calls.hpp"
#include "ui/number_text.hpp"
#include "ui/panels/explain/ball_text.hpp"
#include "ui/panels/explain/details_state.hpp"
#include "ui/panels/panel.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/table_cells.hpp"
#include "ui/widgets/widgets.hpp"
#include "core/document/explain/simplex_details.hpp"
#include "core/selection/prepare_balls.hpp"
#include "core/document/store/store.hpp"
#include "core/document/store/definition.hpp"
#include "core/document/store/inputs.hpp"

namespace alphascope {
namespace {

using Balls = std::vector<BallIndex>;

constexpr const char* kPlural[] = {"vertices", "edges", "triangles", "tetrahedra"};

std::string number(std::size_t n) {
  return with_separators(static_cast<long long>(n));
}

std::string simplices_counted(std::size_t n, std::size_t corners) {
  return number(n) + " " + (n == 1 ? simplex_kind_name(corners) : kPlural[corners - 1]);
}

void fact(PanelContext& ctx, const char* label, const std::string& text) {
  const float left = ImGui::GetCursorPosX();
  muted_text(ctx, label);
  ImGui::SameLine(left + ctx.px(92));
  wrapped_text(text);
  record(ctx, ("details.fact." + std::string(label)).c_str());
}

// Returns a text such as "5 edges, 7 triangles, 2 tetrahedra".
std::string cofaces_text(const SimplexDetails& details) {
  std::string text;
  for (std::size_t corners = details.balls.size() + 1; corners <= 4; ++corners) {
    text += (text.empty() ? "" : ", ") + simplices_counted(details.cofaces[corners - 1], corners);
  }
  return text;
}

std::string class_text(const SimplexDetails& details) {
  if (!details.in_complex) return "not in the complex at this alpha";
  if (!details.simplex_class) return "not computed with “Tetrahedra only”";
  return simplex_class_name(*details.simplex_class);
}

void atom_facts(PanelContext& ctx, const BallReferences& atoms, std::size_t atom) {
  const Molecule& molecule = atoms.molecule();
  const Atom& a = molecule.atoms[atom];
  fact(ctx, "atom", atom_label(molecule, atom));
  fact(ctx, "element",
       a.element == kUnknownElement ? "unknown" : std::string(element_symbol(a.element)));
  fact(ctx, "centre", place_text(a.position, molecule.lattice) + " Å");
  if (const auto ball = atoms.ball(atoms.atom_of_molecule(atom))) {
    const Answer* const shown = ctx.state.result.get();
    fact(ctx, "size",
         radius_text(*atoms.prepared().balls, shown ? &shown->request : nullptr, *ball));
  } else {
    fact(ctx, "size", "no ball: the selection at the left leaves it out");
  }
  if (a.has_b_factor) {
    const std::string value = number_text(static_cast<double>(a.b_factor), 2);
    if (molecule.has_confidences) {
      fact(ctx, "pLDDT", value);
    } else {
      fact(ctx, "B factor", value + " Å²");
    }
  }
  if (a.occupancy != 1) fact(ctx, "occupancy", short_number_text(double(a.occupancy), 2));
}

void simplex_facts(PanelContext& ctx, const SimplexDetails& details) {
  fact(ctx, "class", class_text(details));
  if (details.alpha_value_angstrom2) {
    fact(ctx, "alpha value", short_number_text(*details.alpha_value_angstrom2, 4) + " Å²");
  }
  if (details.balls.size() < 4) fact(ctx, "is part of", cofaces_text(details));
}

// Draws a line for an atom or simplex. A click on it selects the thing, and the button moves the
// view to it.
void leads_to(PanelContext& ctx, const std::string& name, const Ref& ref, const std::string& text,
              const std::string& value) {
  ViewState& s = ctx.state;
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushID(name.c_str());
  const std::string fitted = fitted_text(text, ImGui::GetContentRegionAvail().x);
  if (ImGui::Selectable(
          fitted.c_str(), s.settings.selection.items.contains(ref),
          ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowItemOverlap)) {
    s.settings.selection.items = RefSet({ref});
  }
  record(ctx, name.c_str());
  tooltip(ctx, (name_of(s.references->molecule(), ref) + "\nClick to select it.").c_str());
  number_cell(value);
  ImGui::TableNextColumn();
  if (row_button(ctx, (name + ".zoom").c_str(), "Zoom", 48)) {
    ctx.calls.view.zoom_to(RefSet({ref}));
  }
  tooltip(ctx, "Moves the view to it.");
  ImGui::PopID();
}

struct Lines {
  const BallReferences& atoms;
  const SimplexDetails& details;

  const Molecule& molecule() const { return atoms.molecule(); }
  std::size_t corners() const { return details.balls.size() == 1 ? 0 : details.balls.size(); }
  std::size_t size() const { return corners() + details.neighbours.size() + details.beside.size(); }
  // Returns the ball that `simplex` has in addition to `details.balls`.
  BallIndex further_ball(const Balls& simplex) const {
    return *std::find_if(simplex.begin(), simplex.end(), [this](BallIndex ball) {
      return !std::binary_search(details.balls.begin(), details.balls.end(), ball);
    });
  }
  void draw(PanelContext& ctx, std::size_t n) const {
    if (n < corners()) {
      const Ref ref = atoms.atom(details.balls[n]);
      return leads_to(ctx, "details.corner." + std::to_string(n), ref, name_of(molecule(), ref),
                      "vertex");
    }
    n -= corners();
    if (n < details.neighbours.size()) {
      const NeighbourBall& neighbour = details.neighbours[n];
      const Ref ref = atoms.atom(neighbour.ball);
      return leads_to(ctx, "details.neighbour." + std::to_string(n), ref, name_of(molecule(), ref),
                      number_text(neighbour.distance_angstrom, 3) + " Å");
    }
    n -= details.neighbours.size();
    leads_to(ctx, "details.beside." + std::to_string(n), atoms.reference(details.beside[n]),
             "with " + name_of(molecule(), atoms.atom(further_ball(details.beside[n]))), "");
  }
};

// Returns the title of the list.
std::string lines_title(const SimplexDetails& details) {
  const std::size_t corners = details.balls.size();
  if (corners == 1) {
    const std::size_t n = details.neighbours.size();
    return number(n) + (n == 1 ? " neighbour" : " neighbours") + ", joined by an edge";
  }
  const std::string all = details.beside.size() == SimplexDetails::kMostListed ? "the first " : "";
  return std::to_string(corners) + " vertices; " + all +
         simplices_counted(details.beside.size(), std::min<std::size_t>(corners + 1, 4)) +
         (corners == 4 ? " beside it" : " with it");
}

void list_around(PanelContext& ctx, const BallReferences& atoms, const SimplexDetails& details) {
  muted_text(ctx, fitted_text(lines_title(details), ImGui::GetContentRegionAvail().x));
  record(ctx, "details.around");
  const Lines lines{atoms, details};
  if (lines.size() == 0) return;
  if (!ImGui::BeginTable("around", 3, ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg)) return;
  ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthFixed, ctx.px(62));
  ImGui::TableSetupColumn("zoom", ImGuiTableColumnFlags_WidthFixed, ctx.px(52));
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(lines.size()));
  while (clipper.Step()) {
    for (int n = clipper.DisplayStart; n < clipper.DisplayEnd; ++n) {
      lines.draw(ctx, static_cast<std::size_t>(n));
    }
  }
  ImGui::EndTable();
}

// Returns the selected atom. An atom beside the body has no ball, so only the molecule knows it.
std::optional<std::size_t> one_atom(const ViewState& s) {
  const auto& items = s.settings.selection.items.items();
  const AtomRef* const ref = items.size() == 1 ? std::get_if<AtomRef>(&items[0]) : nullptr;
  return ref ? find_atom(s.references->molecule(), {ref->atom, ref->copy}) : std::nullopt;
}

// Returns the latest answer for these balls, also while a newer one is made.
const SimplexDetails* details_of(PanelContext& ctx, DetailsState& memory, const Balls& balls) {
  const auto found = ctx.store.want(simplex_details(balls), ctx.inputs);
  if (found.ready()) {
    memory.shown = found.value;
    memory.atoms = ctx.inputs.atoms;
  }
  const bool fits =
      memory.shown && memory.shown->balls == balls && memory.atoms == ctx.inputs.atoms;
  return fits ? memory.shown.get() : nullptr;
}

void draw_details(PanelContext& ctx, DetailsState& memory, float facts_width) {
  ViewState& s = ctx.state;
  const bool known = ctx.inputs.complex && ctx.inputs.atoms;
  const SelectedSimplex asked =
      known ? selected_simplex(s.settings.selection.items, *ctx.inputs.atoms) : SelectedSimplex{};
  const std::optional<std::size_t> atom = one_atom(s);
  const SimplexDetails* const details =
      asked.balls.empty() ? nullptr : details_of(ctx, memory, asked.balls);
  ImGui::BeginChild("facts", {facts_width, 0}, false);
  if (atom) {
    strong_text(ctx, atom_address(s.references->molecule(), *atom));
    atom_facts(ctx, *s.references, *atom);
  } else if (!asked.balls.empty()) {
    strong_text(ctx, std::string(simplex_kind_name(asked.balls.size())) + " of " +
                         std::to_string(asked.balls.size()) + " atoms");
  } else {
    muted_wrapped(ctx, asked.why_not.empty() ? "Select an atom or a simplex." : asked.why_not);
    record(ctx, "details.nothing");
  }
  if (details) simplex_facts(ctx, *details);
  ImGui::EndChild();
  ImGui::SameLine(0, ctx.px(12));
  ImGui::BeginChild("around", {facts_width, 0}, false);
  if (details) list_around(ctx, *ctx.inputs.atoms, *details);
  ImGui::EndChild();
}

void draw_details(PanelContext& ctx, DetailsState& memory) {
  if (!ctx.state.references) {
    return muted_wrapped(ctx, "Open a molecule: its selected atoms are described here.");
  }
  ImGui::NewLine();
  const float gap = ctx.px(12);
  const float width = ImGui::GetContentRegionAvail().x;
  draw_details(ctx, memory, std::floor(width * 0.27f));
  ImGui::SameLine(0, gap);
  ImGui::BeginChild("measured", {0, 0}, false);
  draw_measured_list(ctx);
  ImGui::EndChild();
}

}  // namespace

std::unique_ptr<Panel> details_panel() {
  return panel_of(draw_details);
}

}  // namespace alphascope
