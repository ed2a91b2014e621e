// SPDX-License-Identifier: GPL-3.0-or-later
// All settings that decide how the picture looks: display, theme, clip, and hidden or coloured
// atoms.
#pragma once

#include "core/document/reference/appearance.hpp"
#include "core/document/settings/clip.hpp"
#include "core/document/settings/display.hpp"
#include "core/document/settings/drawn_object.hpp"
#include "ui/theme.hpp"

namespace alphascope {

struct SceneControls {
  DisplaySettings display;
  Theme theme = Theme::dark;
  float line_scale = 1;  // as in SceneStyle
  Clip clip;
  Appearance appearance;  // hidden atoms and chosen colours
  DrawnObjects objects;
};

}  // namespace alphascope
