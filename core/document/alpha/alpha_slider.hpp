// SPDX-License-Identifier: GPL-3.0-or-later
// Maps positions on the alpha slider to alpha, and steps alpha in playback. Plain numbers, no
// widget.
#pragma once

#include <cstdint>
#include <vector>

namespace alphascope {

struct Signature;

// root: even steps of the signed square root, that is, of a length. logarithm: signed, and nearly
// linear where |alpha| is below 0.01 Å².
enum class AlphaScaling : std::uint8_t { linear, root, logarithm };

struct AlphaSlider {
  AlphaScaling scaling = AlphaScaling::linear;
  double low = -3, high = 10;  // ends, Å²; alpha may lie outside and is not moved
  bool loop = false;           // playback continues at the other end
  double speed = 1;            // of playback: 1 crosses the slider in 260 pictures
  friend bool operator==(const AlphaSlider&, const AlphaSlider&) = default;
};

// Position of alpha (Å²) on the slider, from 0 to 1; beyond the ends 0 or 1.
double slider_position_of_alpha(const AlphaSlider& slider, double alpha);
// Alpha (Å²) at a position. It is rounded to a multiple of a power of ten. That power is at most
// the change of alpha over `step`.
double alpha_at_slider_position(const AlphaSlider& slider, double place, double step);

// The next alpha of playback. `ended`: alpha was at the end and the slider does not loop.
struct NextAlpha {
  double alpha = 0;  // Å²
  bool ended = false;
};
NextAlpha next_alpha(const AlphaSlider& slider, double alpha, bool backwards);

// Sets the ends so that they include the least critical value, and 98 % of those of tetrahedra. A
// single far outlier does not count.
void fit_range(AlphaSlider& slider, const Signature& signature);

// Number of simplices of all dimensions that appear in each of `columns` equal parts of the slider.
std::vector<std::uint32_t> critical_values(const AlphaSlider& slider, const Signature& signature,
                                           std::size_t columns);

}  // namespace alphascope
