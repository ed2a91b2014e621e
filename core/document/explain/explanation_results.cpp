// SPDX-License-Identifier: GPL-3.0-or-later
// Definitions of explained simplices, and the reading of a selection.
#include "core/document/explain/explanation_results.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/document/reference/reference.hpp"
#include "core/document/store/definition.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/key.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/triangulation/memory_need.hpp"

namespace alphascope {
namespace {

// Memory for one pass over all balls for each point, and for a triangulation of some hundred balls.
MemoryNeed explanation_memory(const Inputs&) {
  return {50'000, 20'000'000};
}

}  // namespace

SelectedSimplex selected_simplex(const RefSet& selection, const BallReferences& atoms) {
  const auto& items = selection.items();
  if (items.empty()) {
    return {{},
            "Click an atom, edge, triangle or tetrahedron in the picture. Ctrl+click two to "
            "four atoms to explain their simplex, in the complex or not."};
  }
  const bool all_atoms = std::all_of(items.begin(), items.end(), [](const Ref& item) {
    return std::holds_alternative<AtomRef>(item);
  });
  if (items.size() > 4 || (items.size() > 1 && !all_atoms)) {
    return {{}, "Too much is selected. Select one simplex, or one to four atoms."};
  }
  SelectedSimplex asked;
  for (const Ref& item : items) {
    const auto balls = atoms.balls(item);
    if (!balls) {
      return {{}, "The selection has no ball: the choice of atoms at the left leaves it out."};
    }
    asked.balls.insert(asked.balls.end(), balls->begin(), balls->end());
  }
  std::sort(asked.balls.begin(), asked.balls.end());
  return asked;
}

Definition<ExplainedSimplex> explained_simplex(const std::vector<BallIndex>& simplex) {
  return {{.id = "explanation",
           .title = "Explanation of a simplex",
           .key =
               [simplex](const Inputs& in) {
                 if (!in.atoms) return Key{};
                 Key key = key_of_balls_and_alpha(in);
                 for (const BallIndex ball : simplex)
                   key.more = Key{key.more + 1, ball, 0}.number();
                 return key;
               },
           .memory = explanation_memory,
           .lane = Lane::interactive},
          [simplex](const Inputs& in, const RunContext& context) {
            auto result = std::make_shared<ExplainedSimplex>();
            std::optional<LatticeAlpha> alpha;
            if (!std::isnan(in.alpha_angstrom2.nearest())) {
              alpha = in.balls->lattice.alpha_on_lattice(in.alpha_angstrom2);
            }
            result->explanation = explain(*in.balls, simplex, alpha, context);
            result->lines = explanation_lines(
                result->explanation, [&](BallIndex ball) { return atom_text(*in.atoms, ball); });
            return std::shared_ptr<const ExplainedSimplex>(std::move(result));
          }};
}

}  // namespace alphascope
