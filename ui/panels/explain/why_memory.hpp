// What the page "Why?" remembers between frames. Plain data.
#pragma once

#include <cstdint>
#include <memory>

#include "core/document/explain/explanation_results.hpp"
#include "ui/layer.hpp"

namespace alphascope {

struct WhyMemory {
  // The last answer, grey while it is not that of the present question, and what is drawn of it.
  std::shared_ptr<const ExplainedSimplex> shown;
  std::shared_ptr<const BallSet> balls;
  std::shared_ptr<const Layer> layer;
  std::uint64_t layers_made = 0;
};

}  // namespace alphascope
