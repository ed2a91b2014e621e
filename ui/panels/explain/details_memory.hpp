// What the page "Details" remembers between frames. Plain data.
#pragma once

#include <memory>

#include "core/document/explain/simplex_details.hpp"

namespace alphascope {

struct DetailsMemory {
  // The last answer, grey while it is not that of what is selected; null: none.
  std::shared_ptr<const SimplexDetails> shown;
  std::shared_ptr<const BallReferences> atoms;  // of its balls
};

}  // namespace alphascope
