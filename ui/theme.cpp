// SPDX-License-Identifier: GPL-3.0-or-later
// The two palettes. Text colours have at least the contrast 4.5 : 1 of WCAG 2.1 on their panel.
#include "ui/theme.hpp"

namespace alphascope {
namespace {

constexpr Colour rgb(std::uint32_t hex, float alpha = 1.0f) {
  return {static_cast<float>((hex >> 16) & 0xff) / 255.0f,
          static_cast<float>((hex >> 8) & 0xff) / 255.0f, static_cast<float>(hex & 0xff) / 255.0f,
          alpha};
}

constexpr Palette kDark = {
    .panel = rgb(0x1b1f26),
    .panel_raised = rgb(0x232932),
    .field = rgb(0x2b323d),
    .field_hovered = rgb(0x364050),
    .field_active = rgb(0x3f4c60),
    .border = rgb(0x343c49),
    .text = rgb(0xe4e8ee),
    .text_muted = rgb(0x9aa5b4),
    .text_disabled = rgb(0x667080),
    .accent = rgb(0x4c9aff),
    .accent_hovered = rgb(0x6bb0ff),
    .accent_text = rgb(0x0b1420),
    .success = rgb(0x5fd38d),
    .warning = rgb(0xf2b84b),
    .error = rgb(0xff7b72),
    .success_fill = rgb(0x17392a),
    .warning_fill = rgb(0x3d3015),
    .error_fill = rgb(0x451f1f),
    .scene = rgb(0x11151b),
    .complex_single = rgb(0x5aa9e6),
    .selected = rgb(0x52ff3d),
    .bar_ours = rgb(0x4c9aff),
    .bar_cgal = rgb(0xc68a3e),
    .bar_ours_setup = rgb(0x2f5f9e),
    .bar_cgal_setup = rgb(0x7d5a2b),
};

constexpr Palette kLight = {
    .panel = rgb(0xf5f6f8),
    .panel_raised = rgb(0xffffff),
    .field = rgb(0xe3e7ed),
    .field_hovered = rgb(0xd5dbe4),
    .field_active = rgb(0xc6cfdb),
    .border = rgb(0xcdd3dc),
    .text = rgb(0x1c232d),
    .text_muted = rgb(0x566170),
    .text_disabled = rgb(0x98a2b0),
    .accent = rgb(0x1668c7),
    .accent_hovered = rgb(0x0f57ab),
    .accent_text = rgb(0xffffff),
    .success = rgb(0x116b3a),
    .warning = rgb(0x85560a),
    .error = rgb(0xb3261e),
    .success_fill = rgb(0xd8f1e2),
    .warning_fill = rgb(0xfbecc8),
    .error_fill = rgb(0xfbdcd9),
    .scene = rgb(0xffffff),
    .complex_single = rgb(0x2f7fc4),
    .selected = rgb(0x12a800),
    .bar_ours = rgb(0x2f7fd6),
    .bar_cgal = rgb(0xc07f2a),
    .bar_ours_setup = rgb(0x9cc3ee),
    .bar_cgal_setup = rgb(0xe4c79a),
};

}  // namespace

const Palette& palette(Theme theme) {
  return theme == Theme::dark ? kDark : kLight;
}

}  // namespace alphascope
