// SPDX-License-Identifier: GPL-3.0-or-later
// Chooses the quality of drawing from the times measured so far. Moving pictures are to be smooth.
// Pictures at rest are to be as good as possible without delaying the next input. Pure logic.
#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "ui/scene/scene.hpp"

namespace alphascope {

class QualityChooser {
 public:
  // Milliseconds that a frame may take. The budget is small during a computation, because drawing
  // uses the same cores.
  static constexpr double kMovingBudget = 45, kComputingBudget = 12, kRestBudget = 1500;

  void note(RenderQuality quality, double milliseconds) {
    taken_[static_cast<std::size_t>(quality)] = milliseconds;
  }
  // To be called for another molecule or another window size, where measured times no longer hold.
  void forget() { taken_ = {}; }

  RenderQuality moving() const { return best_within(kMovingBudget); }
  // Milliseconds expected for a picture of a moving view. 0 before any measurement.
  double moving_milliseconds() const { return expected(moving()).value_or(0); }
  RenderQuality while_computing() const { return best_within(kComputingBudget); }
  // Fine, so samples add up one after another. Draft before any measurement, or if one sample would
  // delay input for too long.
  RenderQuality at_rest() const {
    if (!expected(RenderQuality::draft)) return RenderQuality::draft;
    return *expected(RenderQuality::fine) <= kRestBudget ? RenderQuality::fine
                                                         : RenderQuality::draft;
  }
  // Milliseconds expected for a sample. Before any measurement: kRestBudget.
  double sample() const { return expected(RenderQuality::fine).value_or(kRestBudget); }

 private:
  // Times in software OpenGL, as multiples of a draft's. A fine sample has fewer occlusion taps
  // than a medium picture.
  static constexpr std::array<double, 4> kRelativeCost{0.4, 1, 3, 2};

  std::optional<double> expected(RenderQuality quality) const {
    const auto q = static_cast<std::size_t>(quality);
    if (taken_[q]) return taken_[q];
    for (std::size_t known = 0; known < taken_.size(); ++known) {
      if (taken_[known]) return *taken_[known] * kRelativeCost[q] / kRelativeCost[known];
    }
    return std::nullopt;
  }

  RenderQuality best_within(double budget) const {
    if (!expected(RenderQuality::draft)) return RenderQuality::draft;
    for (const RenderQuality q : {RenderQuality::medium, RenderQuality::draft}) {
      if (*expected(q) <= budget) return q;
    }
    return RenderQuality::sketch;
  }

  std::array<std::optional<double>, 4> taken_{};
};

}  // namespace alphascope
