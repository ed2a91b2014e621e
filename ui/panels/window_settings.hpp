// SPDX-License-Identifier: GPL-3.0-or-later
// The arrangement of the window, and choices in its dialogs. Sessions and preferences keep them,
// and undo leaves them alone.
#pragma once

#include <set>
#include <string>

#include "core/document/alpha/alpha_slider.hpp"
#include "core/document/picture/picture_options.hpp"
#include "ui/theme.hpp"

namespace alphascope {

struct WindowSettings {
  Theme theme = Theme::dark;
  double control_scale = 0;     // size of fonts and controls; 0: as the display says
  bool presenter_size = false;  // enlarges fonts and controls further, for a projector
  bool glide = true;            // commands move the view in a short time instead of at once
  bool auto_compare = false;    // compare with CGAL after each change

  std::string page;         // id of the page below the view; empty: as ViewState::page() says
  std::string chosen_page;  // the page that the user chose last by its name; empty: none
  float page_height = 0;    // pixels at scale 1; 0: default
  std::set<std::string> closed_sections{"look"};  // ids of closed sections at the left
  AlphaSlider alpha_slider;
  bool clip_handle = true;  // shows the handle in the picture while there is a clip
  bool why_marks = true;    // the page Why? draws the orthosphere and the balls that decide

  PictureOptions picture;  // choices in the dialog that saves a picture
};

}  // namespace alphascope
