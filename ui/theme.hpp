// SPDX-License-Identifier: GPL-3.0-or-later
// Colours of the window, dark and light, for panels and scene. Knows neither ImGui nor VTK; panels
// and scene convert a Colour into their libraries' types.
#pragma once

#include <cstdint>

namespace alphascope {

enum class Theme : std::uint8_t { dark, light };

// Components from 0 to 1, not premultiplied.
struct Colour {
  float r = 0, g = 0, b = 0, a = 1;
};

struct Palette {
  Colour panel, panel_raised, field, field_hovered, field_active, border;
  Colour text, text_muted, text_disabled;
  Colour accent, accent_hovered, accent_text;     // accent_text is readable on accent
  Colour success, warning, error;                 // as text on a panel, contrast >= 4.5 : 1
  Colour success_fill, warning_fill, error_fill;  // behind that text, as a badge
  Colour scene;                                   // background of the 3-D view
  Colour complex_single;                          // simplices in one colour
  Colour selected;                                // selected objects in the picture
  // Bars of the stages of our engine and of CGAL, and of the set-up of both.
  Colour bar_ours, bar_cgal, bar_ours_setup, bar_cgal_setup;
};

const Palette& palette(Theme theme);

}  // namespace alphascope
