// SPDX-License-Identifier: GPL-3.0-or-later
// The common parts of explain and steps: finding balls by name or index, and printing sentences in
// columns.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "app/cli/input.hpp"
#include "core/document/explain/explanation_text.hpp"
#include "core/document/reference/reference.hpp"

namespace alphascope::cli {

struct AddressedBalls {
  std::vector<BallIndex> balls;
  bool others = false;  // some named atoms are not balls
  // A sentence on the atoms that are not balls; empty if there are none.
  std::string note_on_others() const;
};
// `text` is an address or an expression. Throws UsageError that names the option.
AddressedBalls balls_by_address(const BallReferences& atoms, const std::string& option,
                                const std::string& text);
// Throws UsageError that names the option if the ball does not exist.
BallIndex ball_by_index(const Input& input, const std::string& option, int index);

// Prints lines of at most 96 columns, with the heading in the margin of the first.
void print_line(std::ostream& out, const ExplanationLine& line);

}  // namespace alphascope::cli
