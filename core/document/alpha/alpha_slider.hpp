// How the alpha slider maps its length to alpha, and how alpha plays: plain numbers, no widget.
#pragma once

#include <cstdint>
#include <vector>

namespace alphascope {

struct Signature;

// root: even steps of the signed square root, so of lengths. logarithm: signed, and linear within
// some 0.01 Å² of 0.
enum class AlphaScaling : std::uint8_t { linear, root, logarithm };

struct AlphaSlider {
  AlphaScaling scaling = AlphaScaling::linear;
  double low = -3, high = 10;  // Å², its ends; alpha may lie outside and stays where it is
  bool loop = false;           // playing goes on at the other end
  double speed = 1;            // of playing: 1 crosses the slider in 260 pictures
  friend bool operator==(const AlphaSlider&, const AlphaSlider&) = default;
};

// From 0 to 1 along the slider; beyond its ends 0 or 1.
double place_of_alpha(const AlphaSlider& slider, double alpha);
// Å². Rounded to a power of ten, times 1, that is no coarser than a step of `step` along it.
double alpha_at_place(const AlphaSlider& slider, double place, double step);

// What playing asks for next, forwards or backwards; `ended`: it was at the end and does not loop.
struct NextAlpha {
  double alpha = 0;  // Å²
  bool ended = false;
};
NextAlpha next_alpha(const AlphaSlider& slider, double alpha, bool backwards);

// The ends that show nearly all critical values of tetrahedra, and the smallest of all: one far
// outlier does not count.
void fit_range(AlphaSlider& slider, const Signature& signature);

// How many simplices of any dimension appear along each of `columns` equal parts of the slider.
std::vector<std::uint32_t> critical_values(const AlphaSlider& slider, const Signature& signature,
                                           std::size_t columns);

}  // namespace alphascope
