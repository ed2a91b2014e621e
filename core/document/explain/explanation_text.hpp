// SPDX-License-Identifier: GPL-3.0-or-later
// An explanation (core/explain/explanation.hpp) in sentences, for readers who have never seen a
// power diagram.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/explain/explanation.hpp"

namespace alphascope {

using BallName = std::function<std::string(BallIndex)>;  // "A:HIS 87:NE2"

// Sentences under one heading.
struct ExplanationLine {
  std::string heading;  // one or two words
  std::string text;
  // The simplex or ball that decides, so that the user can go to it; empty: none.
  std::vector<BallIndex> about = {};
};
std::vector<ExplanationLine> explanation_lines(const Explanation& e, const BallName& name);

// "edge of balls 3 (A:VAL 1:CA) and 7 (A:GLY 2:O)"
std::string simplex_text(const std::vector<BallIndex>& simplex, const BallName& name);

const char* simplex_class_name(SimplexClass simplex_class);  // "singular"

}  // namespace alphascope
