// SPDX-License-Identifier: GPL-3.0-or-later
// How different two colours look, with usual sight and with colour blindness.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "core/molecule/atom_colours.hpp"

namespace alphascope::testing {

struct LabColour {
  double lightness = 0, a = 0, b = 0;
};

// CIEDE2000 with all weights 1. Source: G. Sharma, W. Wu, E. N. Dalal, "The CIEDE2000
// color-difference formula: implementation notes, supplementary test data, and mathematical
// observations", Color Research and Application 30, 2005.
inline double ciede2000(const LabColour& x, const LabColour& y) {
  constexpr double kDegree = M_PI / 180;
  const auto seventh = [](double c) {
    const double c7 = std::pow(c, 7);
    return std::sqrt(c7 / (c7 + 6103515625.0));  // 25 to the 7th
  };
  const double mean_chroma = (std::hypot(x.a, x.b) + std::hypot(y.a, y.b)) / 2;
  const double stretch = 1 + 0.5 * (1 - seventh(mean_chroma));
  const double ax = stretch * x.a, ay = stretch * y.a;
  const double cx = std::hypot(ax, x.b), cy = std::hypot(ay, y.b);
  const auto hue = [](double a, double b) {
    const double degrees = a == 0 && b == 0 ? 0 : std::atan2(b, a) / kDegree;
    return degrees < 0 ? degrees + 360 : degrees;
  };
  const double hx = hue(ax, x.b), hy = hue(ay, y.b);
  double turn = 0, hue_mean = hx + hy;
  if (cx * cy != 0) {
    turn = hy - hx;
    if (turn > 180) turn -= 360;
    if (turn < -180) turn += 360;
    const bool across = std::fabs(hx - hy) > 180;
    hue_mean = (hue_mean + (!across ? 0 : hue_mean < 360 ? 360 : -360)) / 2;
  }
  const double dl = y.lightness - x.lightness, dc = cy - cx;
  const double dh = 2 * std::sqrt(cx * cy) * std::sin(turn * kDegree / 2);
  const double l = (x.lightness + y.lightness) / 2 - 50, c = (cx + cy) / 2;
  const double t = 1 - 0.17 * std::cos((hue_mean - 30) * kDegree) +
                   0.24 * std::cos(2 * hue_mean * kDegree) +
                   0.32 * std::cos((3 * hue_mean + 6) * kDegree) -
                   0.20 * std::cos((4 * hue_mean - 63) * kDegree);
  const double sl = 1 + 0.015 * l * l / std::sqrt(20 + l * l), sc = 1 + 0.045 * c;
  const double sh = 1 + 0.015 * c * t;
  const double theta = 30 * std::exp(-std::pow((hue_mean - 275) / 25, 2));
  const double turned = -2 * seventh(c) * std::sin(2 * theta * kDegree);
  return std::sqrt(std::pow(dl / sl, 2) + std::pow(dc / sc, 2) + std::pow(dh / sh, 2) +
                   turned * (dc / sc) * (dh / sh));
}

enum class ViewFrustum { usual, protanopia, deuteranopia, tritanopia };
inline constexpr std::array kSights{ViewFrustum::usual, ViewFrustum::protanopia,
                                    ViewFrustum::deuteranopia, ViewFrustum::tritanopia};

// A matrix for linear sRGB at severity 1. Source: G. M. Machado, M. M. Oliveira, L. A. F.
// Fernandes, "A physiologically-based model for simulation of color vision deficiency", IEEE
// Transactions on Visualization and Computer Graphics 15, 2009.
inline std::array<double, 9> simulation(ViewFrustum sight) {
  switch (sight) {
    case ViewFrustum::protanopia:
      return {0.152286, 1.052583,  -0.204868, 0.114503, 0.786281,
              0.099216, -0.003882, -0.048116, 1.051998};
    case ViewFrustum::deuteranopia:
      return {0.367322, 0.860646,  -0.227968, 0.280085, 0.672501,
              0.047413, -0.011820, 0.042940,  0.968881};
    case ViewFrustum::tritanopia:
      return {1.255528, -0.076749, -0.178779, -0.078411, 0.930809,
              0.147602, 0.004733,  0.691367,  0.303900};
    default:
      return {1, 0, 0, 0, 1, 0, 0, 0, 1};
  }
}

// CIE L*a*b* of an sRGB colour as this sight sees it. White is D65.
inline LabColour seen(const Rgb8& colour, ViewFrustum sight) {
  const auto linear = [](int byte) {
    const double c = byte / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  const double rgb[] = {linear(colour.r), linear(colour.g), linear(colour.b)};
  const std::array<double, 9> m = simulation(sight);
  double s[3];
  for (std::size_t k = 0; k < 3; ++k) {
    const double value = m[3 * k] * rgb[0] + m[3 * k + 1] * rgb[1] + m[3 * k + 2] * rgb[2];
    s[k] = std::clamp(value, 0.0, 1.0);
  }
  const double x = 0.4124564 * s[0] + 0.3575761 * s[1] + 0.1804375 * s[2];
  const double y = 0.2126729 * s[0] + 0.7151522 * s[1] + 0.0721750 * s[2];
  const double z = 0.0193339 * s[0] + 0.1191920 * s[1] + 0.9503041 * s[2];
  const auto f = [](double t) {
    return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116;
  };
  const double fx = f(x / 0.95047), fy = f(y), fz = f(z / 1.08883);
  return {116 * fy - 16, 500 * (fx - fy), 200 * (fy - fz)};
}

inline double difference(const Rgb8& a, const Rgb8& b, ViewFrustum sight) {
  return ciede2000(seen(a, sight), seen(b, sight));
}

// The least difference over usual sight and all kinds of colour blindness.
inline double least_difference(const Rgb8& a, const Rgb8& b) {
  double least = difference(a, b, ViewFrustum::usual);
  for (const ViewFrustum sight : kSights) least = std::min(least, difference(a, b, sight));
  return least;
}

}  // namespace alphascope::testing
