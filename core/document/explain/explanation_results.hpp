// Why what is selected is in the complex, as a derived result.
#pragma once

#include <string>
#include <vector>

#include "core/document/explain/explanation_text.hpp"
#include "core/document/store/derived.hpp"

namespace alphascope {

// One to four balls, or a sentence that says why there are none.
struct AskedSimplex {
  std::vector<BallIndex> balls;  // ascending
  std::string why_not;
};
// What a selection asks about: the one atom or simplex in it, or the simplex of two to four atoms,
// whether it is there or not.
AskedSimplex asked_simplex(const RefSet& selection, const BallReferences& atoms);

struct ExplainedSimplex {
  Explanation explanation;
  std::vector<ExplanationLine> lines;
};

// At the alpha of the inputs, whose atoms must be known.
Definition<ExplainedSimplex> explained_simplex(const std::vector<BallIndex>& simplex);

}  // namespace alphascope
