// SPDX-License-Identifier: GPL-3.0-or-later
// From which alpha on a ball is saturated, as the thesis calls it: from then on its star is final
// (core/rounds/thesis_rounds.hpp). Only the ball's surroundings are computed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/geometry/ball_index.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

struct BallSet;

struct BallSaturation {
  enum class State : std::uint8_t {
    saturates,  // from some alpha on
    on_hull,    // never, as its cell has no end
    hidden,     // never, as it has no cell
    flat        // never: the centres of all balls are in one plane
  };
  State state = State::flat;
  std::size_t tetrahedra = 0;  // of its star in the whole triangulation

  // The following are set only if it saturates. The alpha is the largest ortho-radius of its star.
  double angstrom2 = 0;
  std::array<BallIndex, 4> last{};  // the tetrahedron with that ortho-radius
  std::size_t round = 0;            // the first of the thesis' rounds after which it is saturated;
                                    // 0: none
};

// Throws std::invalid_argument if there is no such ball. Works in the caller's task arena. Throws
// Cancelled.
BallSaturation ball_saturation(const BallSet& balls, BallIndex ball,
                               const RunContext& context = {});

}  // namespace alphascope
