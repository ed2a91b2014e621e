// SPDX-License-Identifier: GPL-3.0-or-later
// Scales of the slider and steps of playback, and ranges and histograms from a signature.
#include "core/document/alpha/alpha_slider.hpp"

#include <algorithm>
#include <cmath>

#include "core/document/alpha/signature.hpp"
#include "core/document/commands/number_input.hpp"
#include "core/molecule/name_table.hpp"

namespace alphascope {
namespace {

constexpr double kLinearWithin = 0.01;  // Å²; the logarithm is linear below
constexpr double kPictures = 260;  // number of pictures in which playback crosses the slider: 0.05
                                   // Å² each for the default range

double scaled(AlphaScaling scaling, double alpha) {
  const double size = std::fabs(alpha);
  switch (scaling) {
    case AlphaScaling::root:
      return std::copysign(std::sqrt(size), alpha);
    case AlphaScaling::logarithm:
      return std::copysign(std::log1p(size / kLinearWithin), alpha);
    case AlphaScaling::linear:
      break;
  }
  return alpha;
}

double unscaled(AlphaScaling scaling, double value) {
  const double size = std::fabs(value);
  switch (scaling) {
    case AlphaScaling::root:
      return std::copysign(size * size, value);
    case AlphaScaling::logarithm:
      return std::copysign(kLinearWithin * std::expm1(size), value);
    case AlphaScaling::linear:
      break;
  }
  return value;
}

// Alpha (Å²) at a position on the slider, without rounding; positions beyond the ends are allowed.
double exact_alpha(const AlphaSlider& s, double place) {
  const double low = scaled(s.scaling, s.low), high = scaled(s.scaling, s.high);
  return unscaled(s.scaling, low + place * (high - low));
}

}  // namespace

double slider_position_of_alpha(const AlphaSlider& s, double alpha) {
  const double low = scaled(s.scaling, s.low), high = scaled(s.scaling, s.high);
  return std::clamp((scaled(s.scaling, alpha) - low) / (high - low), 0.0, 1.0);
}

double alpha_at_slider_position(const AlphaSlider& s, double place, double step) {
  if (place <= 0) return s.low;
  if (place >= 1) return s.high;
  const double alpha = exact_alpha(s, place);
  const double apart = std::fabs(exact_alpha(s, place + step) - alpha);
  const double digits = std::clamp(-std::floor(std::log10(apart)), -12.0, 6.0);
  const double units = std::pow(10.0, digits);  // dividing by it gives the nearest decimal number
  const double rounded = std::round(alpha * units) / units;
  return std::clamp(rounded == 0 ? 0 : rounded, s.low, s.high);
}

NextAlpha next_alpha(const AlphaSlider& s, double alpha, bool backwards) {
  const double end = backwards ? s.low : s.high, start = backwards ? s.high : s.low;
  const bool over = backwards ? alpha <= end : alpha >= end;
  if (over) return {s.loop ? start : alpha, !s.loop};
  // An alpha outside the slider goes to the nearer end.
  if (backwards ? alpha > start : alpha < start) return {start, false};
  const double step = s.speed / kPictures;
  const double place = slider_position_of_alpha(s, alpha) + (backwards ? -step : step);
  double next = std::clamp(alpha_at_slider_position(s, place, step / 10), s.low, s.high);
  // Near 0 of the root scale, rounding must not stop the playback.
  if (next == alpha) next = exact_alpha(s, place);
  return {next, false};
}

void fit_range(AlphaSlider& slider, const Signature& signature) {
  constexpr double kNearlyAll = 0.98;
  const std::vector<float>& tetrahedra = signature.values[3];
  if (tetrahedra.empty()) return;
  const auto at = static_cast<std::size_t>(kNearlyAll * static_cast<double>(tetrahedra.size() - 1));
  const double high = signature.lattice.square_angstrom(tetrahedra[at]);
  const double low = std::floor(signature.least_alpha());
  slider.low = std::clamp(low, kAlphaRule.least, kAlphaRule.most - 1);
  slider.high = std::clamp(std::ceil(high), slider.low + 1, kAlphaRule.most);
}

std::vector<std::uint32_t> critical_values(const AlphaSlider& slider, const Signature& signature,
                                           std::size_t columns) {
  std::vector<std::uint32_t> counts;
  const auto up_to = [&](std::size_t column) {
    const double alpha =
        exact_alpha(slider, static_cast<double>(column) / static_cast<double>(columns));
    std::size_t all = 0;
    for (int d = 0; d < 4; ++d) all += signature.count(d, alpha);
    return all;
  };
  std::size_t before = columns > 0 ? up_to(0) : 0;
  for (std::size_t column = 1; column <= columns; ++column) {
    const std::size_t now = up_to(column);
    counts.push_back(static_cast<std::uint32_t>(now - std::min(before, now)));
    before = now;
  }
  return counts;
}

}  // namespace alphascope
