// SPDX-License-Identifier: GPL-3.0-or-later
// The list of the simplices around an atom or a simplex.
#include <algorithm>
#include <string>
#include <vector>

#include "core/document/explain/simplex_details.hpp"
#include "core/document/reference/reference.hpp"
#include "core/molecule/molecule.hpp"
#include "ui/calls.hpp"
#include "ui/number_text.hpp"
#include "ui/panels/explain/details_parts.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/table_cells.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

using Balls = std::vector<BallIndex>;

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
    return with_separators(static_cast<long long>(n)) + (n == 1 ? " neighbour" : " neighbours") +
           ", joined by an edge";
  }
  const std::string all = details.beside.size() == SimplexDetails::kMostListed ? "the first " : "";
  return std::to_string(corners) + " vertices; " + all +
         simplices_counted(details.beside.size(), std::min<std::size_t>(corners + 1, 4)) +
         (corners == 4 ? " beside it" : " with it");
}

}  // namespace

void draw_simplices_around(PanelContext& ctx, const BallReferences& atoms,
                           const SimplexDetails& details) {
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

}  // namespace alphascope
