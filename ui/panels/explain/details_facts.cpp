// SPDX-License-Identifier: GPL-3.0-or-later
// Facts on an atom or a simplex, one below the other.
#include <string>

#include "core/document/explain/explanation_text.hpp"
#include "core/document/explain/simplex_details.hpp"
#include "core/document/reference/reference.hpp"
#include "core/molecule/element.hpp"
#include "core/molecule/molecule.hpp"
#include "core/selection/prepare_balls.hpp"
#include "ui/number_text.hpp"
#include "ui/panels/explain/ball_text.hpp"
#include "ui/panels/explain/details_parts.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

constexpr const char* kPlural[] = {"vertices", "edges", "triangles", "tetrahedra"};

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

}  // namespace

std::string simplices_counted(std::size_t n, std::size_t corners) {
  return with_separators(static_cast<long long>(n)) + " " +
         (n == 1 ? simplex_kind_name(corners) : kPlural[corners - 1]);
}

void draw_atom_facts(PanelContext& ctx, const BallReferences& atoms, std::size_t atom) {
  const Molecule& molecule = atoms.molecule();
  const Atom& a = molecule.atoms[atom];
  fact(ctx, "atom", atom_label(molecule, atom));
  fact(ctx, "element",
       a.element == kUnknownElement ? "unknown" : std::string(element_symbol(a.element)));
  fact(ctx, "centre", place_text(a.position, molecule.lattice) + " Å");
  if (const auto ball = atoms.ball(atoms.atom_of_molecule(atom))) {
    fact(ctx, "size", radius_text(*atoms.prepared().balls, ctx.state.shown_request(), *ball));
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

void draw_simplex_facts(PanelContext& ctx, const SimplexDetails& details) {
  fact(ctx, "class", class_text(details));
  if (details.alpha_value_angstrom2) {
    fact(ctx, "alpha value", short_number_text(*details.alpha_value_angstrom2, 4) + " Å²");
  }
  if (details.balls.size() < 4) fact(ctx, "is part of", cofaces_text(details));
}

}  // namespace alphascope
