// SPDX-License-Identifier: GPL-3.0-or-later
// The state of the page “Why?” between frames. Plain data.
#pragma once

#include <cstdint>
#include <memory>

#include "ui/layer.hpp"

namespace alphascope {

struct ExplainedSimplex;

struct WhyState {
  // The last answer and its drawing. It is grey unless it answers the present question.
  std::shared_ptr<const ExplainedSimplex> shown;
  std::shared_ptr<const BallSet> balls;
  std::shared_ptr<const Layer> layer;
  std::uint64_t layers_made = 0;
};

}  // namespace alphascope
