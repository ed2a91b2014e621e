// SPDX-License-Identifier: GPL-3.0-or-later
// Paints the balls anew when only the paint has changed.
#include "app/viewer/scene/ball_colours.hpp"

namespace alphascope {

void BallColours::make(const Paint& paint) {
  if (!picture_.any()) return;
  worker_.submit(
      [this, molecule = picture_.molecule, answer = picture_.answer, paint,
       earlier = picture_.parts.paintings.balls](const RunContext& context) -> Worker::Delivery {
        return [this, molecule, answer,
                painting = make_painting({molecule, answer, paint}, earlier, context)] {
          if (molecule != picture_.molecule || answer != picture_.answer) return;
          picture_.parts.paintings.balls = painting;
          show();
        };
      });
}

void BallColours::show() {
  if (!picture_.molecule || !picture_.parts.paintings.balls) return;
  canvas_.change().set_ball_colours(
      picture_.parts.ball_colours(picture_.molecule->geometry->centres.size()));
}

}  // namespace alphascope
