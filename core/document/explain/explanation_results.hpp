// SPDX-License-Identifier: GPL-3.0-or-later
// Explanations of selected simplices as derived results.
#pragma once

#include <string>
#include <vector>

#include "core/document/explain/explanation_text.hpp"
#include "core/document/store/derived.hpp"

namespace alphascope {

class BallReferences;
class RefSet;

// One to four balls, or a sentence with the reason why there are none.
struct SelectedSimplex {
  std::vector<BallIndex> balls;  // ascending
  std::string why_not;
};
// The simplex that a selection stands for: its only atom or simplex, or the simplex of two to four
// atoms. The simplex need not be in the complex.
SelectedSimplex selected_simplex(const RefSet& selection, const BallReferences& atoms);

struct ExplainedSimplex {
  Explanation explanation;
  std::vector<ExplanationLine> lines;
};

// Explains the simplex at the alpha of the inputs; NaN: for every alpha. Requires Inputs::atoms.
Definition<ExplainedSimplex> explained_simplex(const std::vector<BallIndex>& simplex);

}  // namespace alphascope
