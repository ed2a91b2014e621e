// Chooses how finely to draw from how long drawing has taken: smooth while something moves, the
// best picture at rest that does not hold up the next input. Pure logic.
#pragma once

#include <array>
#include <optional>

#include "ui/scene/scene.hpp"

namespace alphascope {

class QualityChooser {
 public:
  // Milliseconds that a frame may take.
  static constexpr double kMovingBudget = 45, kRestBudget = 700;

  void note(RenderQuality quality, double milliseconds) {
    taken_[static_cast<std::size_t>(quality)] = milliseconds;
  }
  // What was measured says nothing about another molecule or window size.
  void forget() { taken_ = {}; }

  RenderQuality moving() const { return best_within(kMovingBudget); }
  RenderQuality at_rest() const { return best_within(kRestBudget); }

 private:
  // Ambient occlusion doubles a frame, four samples a pixel quadruple it (software OpenGL).
  static constexpr std::array<double, 3> kRelativeCost{1, 2, 8};

  std::optional<double> expected(RenderQuality quality) const {
    const auto q = static_cast<std::size_t>(quality);
    if (taken_[q]) return taken_[q];
    for (std::size_t known = 0; known < taken_.size(); ++known) {
      if (taken_[known]) return *taken_[known] * kRelativeCost[q] / kRelativeCost[known];
    }
    return std::nullopt;
  }

  RenderQuality best_within(double budget) const {
    for (const RenderQuality q : {RenderQuality::fine, RenderQuality::medium}) {
      const auto milliseconds = expected(q);
      if (milliseconds && *milliseconds <= budget) return q;
    }
    return RenderQuality::draft;
  }

  std::array<std::optional<double>, 3> taken_{};
};

}  // namespace alphascope
