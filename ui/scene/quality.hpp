// Chooses how finely to draw from how long drawing has taken: smooth while something moves, the
// best picture at rest that does not hold up the next input. Pure logic.
#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "ui/scene/scene.hpp"

namespace alphascope {

class QualityChooser {
 public:
  // Milliseconds that a frame may take. While pictures follow a computation, both need the cores.
  static constexpr double kMovingBudget = 45, kComputingBudget = 12, kRestBudget = 1500;

  void note(RenderQuality quality, double milliseconds) {
    taken_[static_cast<std::size_t>(quality)] = milliseconds;
  }
  // What was measured says nothing about another molecule or window size.
  void forget() { taken_ = {}; }

  RenderQuality moving() const { return best_within(kMovingBudget); }
  RenderQuality while_computing() const { return best_within(kComputingBudget); }
  // Sample after sample, unless one of them would hold up input for too long.
  RenderQuality at_rest() const {
    if (!expected(RenderQuality::draft)) return RenderQuality::draft;
    return *expected(RenderQuality::fine) <= kRestBudget ? RenderQuality::fine
                                                         : RenderQuality::draft;
  }
  // Milliseconds that a sample takes, as far as anything is known.
  double sample() const { return expected(RenderQuality::fine).value_or(kRestBudget); }

 private:
  // In software OpenGL. A sample of a fine picture has a part of the occlusion of a medium one.
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
