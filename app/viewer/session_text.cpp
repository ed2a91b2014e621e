// SPDX-License-Identifier: GPL-3.0-or-later
// Texts about the pending complex and about its comparison with CGAL.
#include "app/viewer/session_text.hpp"

#include <algorithm>

#include "core/geometry/grown_radius.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/name_table.hpp"
#include "ui/number_text.hpp"
#include "ui/panels/explain/steps_state.hpp"
#include "ui/panels/work_info.hpp"
#include "ui/widgets/format.hpp"

namespace alphascope {
namespace {

std::string count(std::size_t n) {
  return with_separators(static_cast<long long>(n));
}

template <int N>
void add_difference(std::string& text, const SetDifference<N>& difference, const char* what) {
  if (difference.equal()) return;
  if (!text.empty()) text += "; ";
  text += std::string(what) + ": " + count(difference.missing.size()) + " missing, " +
          count(difference.extra.size()) + " extra";
}

std::string differences(const Comparison& c) {
  std::string text;
  add_difference(text, c.tetrahedra, "tetrahedra");
  add_difference(text, c.triangles, "triangles");
  add_difference(text, c.edges, "edges");
  add_difference(text, c.vertices, "vertices");
  if (c.alpha_values_differing > 0) {
    text += (text.empty() ? "" : "; ") + count(c.alpha_values_differing) + " alpha values differ";
  }
  if (c.classes_differing > 0) {
    text += (text.empty() ? "" : "; ") + count(c.classes_differing) + " classes differ";
  }
  return text;
}

}  // namespace

std::string pending_text(const Answer& answer) {
  return "α " + short_number_text(answer.request.alpha_angstrom2, 3) +
         " Å²: " + count(answer.complex.tetrahedra.size()) + " tetrahedra · drawing";
}

std::string cancelled_text(const Request& shown) {
  return "Computing was cancelled. The picture is still of alpha " +
         short_number_text(shown.alpha_angstrom2, 3) + " Å² and solvent radius " +
         short_number_text(shown.solvent_radius_angstrom, 3) + " Å.";
}

BadgeInfo describe_agreement(const SessionState& state, const Answer* shown, bool comparing) {
  if (comparing) return {BadgeInfo::State::comparing, "comparing with CGAL…"};
  if (!state.agreement || state.agreement->ours.get() != shown) {
    return {BadgeInfo::State::not_compared, "not compared with CGAL"};
  }
  const Comparison& c = state.agreement->comparison;
  if (!c.identical()) {
    return {BadgeInfo::State::different, "differs from CGAL: " + differences(c)};
  }
  if (c.both_rest_on_cgal) {
    return {BadgeInfo::State::identical, "identical, but both rest on CGAL's triangulation"};
  }
  const std::string number = count(c.tetrahedra.common);
  return {BadgeInfo::State::identical,
          "identical to CGAL: " + number + " of " + number + " tetrahedra"};
}

}  // namespace alphascope
