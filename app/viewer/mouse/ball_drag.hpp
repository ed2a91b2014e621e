// SPDX-License-Identifier: GPL-3.0-or-later
// A ball of the sandbox that the mouse holds in the 3-D picture. The ball moves in the plane
// through its centre that is parallel to the screen. A sandbox in the plane z = 0 uses that plane
// instead.
#pragma once

#include <cstddef>
#include <optional>

#include "core/molecule/sandbox.hpp"
#include "ui/scene/pick/box_tree.hpp"

namespace alphascope {

class BallDrag {
 public:
  // Nothing where the plane is seen from its edge. `into_view` is a unit vector that points away
  // from the eye.
  static std::optional<BallDrag> begin(const Sandbox& sandbox, std::size_t ball, const Ray& ray,
                                       const SandboxPlace& into_view);

  std::size_t ball() const { return ball_; }
  // The new centre of the ball, Å. Nothing where the line of sight does not meet the plane in front
  // of the eye.
  std::optional<SandboxPlace> place(const Ray& ray) const;

 private:
  std::optional<SandboxPlace> meet(const Ray& ray) const;

  std::size_t ball_ = 0;
  SandboxPlace in_plane_{}, normal_{};
  SandboxPlace grip_{};  // from the point under the mouse to the centre of the ball, Å
};

}  // namespace alphascope
