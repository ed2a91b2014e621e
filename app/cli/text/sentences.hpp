// What explain and steps share: balls as people name them, and sentences in columns.
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
  bool others = false;  // atoms that are no balls were named as well
  // " Atoms that ..." if there are others.
  std::string note_on_others() const;
};
// Of an address or an expression. Throws UsageError that names the option.
AddressedBalls balls_by_address(const BallReferences& atoms, const std::string& option,
                                const std::string& text);
// Throws UsageError that names the option when there is no such ball.
BallIndex ball_by_index(const Input& input, const std::string& option, int index);

// Lines of at most 96 columns; the heading in the first one's margin.
void print_line(std::ostream& out, const ExplanationLine& line);

}  // namespace alphascope::cli
