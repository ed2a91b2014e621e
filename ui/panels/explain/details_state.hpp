// SPDX-License-Identifier: GPL-3.0-or-later
// The state of the page “Details” between frames. Plain data.
#pragma once

#include <memory>

namespace alphascope {

class BallReferences;
struct SimplexDetails;

struct DetailsState {
  // The last answer. It is shown only for the same balls and atoms; null: none.
  std::shared_ptr<const SimplexDetails> shown;
  std::shared_ptr<const BallReferences> atoms;  // references to its balls
};

}  // namespace alphascope
