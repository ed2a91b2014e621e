// A ball of the sandbox that the mouse holds in the 3-D picture: it moves in the plane through its
// centre that is parallel to the screen; where all balls are to stay in the plane z = 0, in that.
#pragma once

#include <cstddef>
#include <optional>

#include "core/molecule/sandbox.hpp"
#include "ui/scene/pick/box_tree.hpp"

namespace alphascope {

class BallDrag {
 public:
  // None where the plane is seen from its edge. `into_view`: a unit vector, from the eye.
  static std::optional<BallDrag> begin(const Sandbox& sandbox, std::size_t ball, const Ray& ray,
                                       const SandboxPlace& into_view);

  std::size_t ball() const { return ball_; }
  // Where the centre is to be, Å; none where the line of sight does not meet the plane before the
  // eye.
  std::optional<SandboxPlace> place(const Ray& ray) const;

 private:
  std::optional<SandboxPlace> meet(const Ray& ray) const;

  std::size_t ball_ = 0;
  SandboxPlace in_plane_{}, normal_{};
  SandboxPlace grip_{};  // from the mouse to the centre
};

}  // namespace alphascope
