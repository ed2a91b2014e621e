// How the window is arranged, and what it remembers of its dialogs: saved with a session or as a
// preference, and left alone by undo.
#pragma once

#include <set>
#include <string>

#include "core/document/alpha/alpha_slider.hpp"
#include "core/document/picture/picture_options.hpp"
#include "ui/theme.hpp"

namespace alphascope {

struct WindowSettings {
  Theme theme = Theme::dark;
  double control_scale = 0;     // of fonts and controls; 0: as the display says
  bool presenter_size = false;  // everything larger than that, to be read on a projector
  bool auto_compare = false;    // with CGAL, after each change

  std::string page;                               // id of the page below the view; empty: the first
  float page_height = 0;                          // pixels at scale 1; 0: default
  std::set<std::string> closed_sections{"look"};  // of the left side
  AlphaSlider alpha_slider;
  bool clip_handle = true;  // shown in the picture, while there is a clip
  bool why_marks = true;    // the page Why? draws the orthosphere and what decides

  PictureOptions picture;   // of the dialog that saves pictures
  RecordChoices recording;  // of the dialog that records
};

}  // namespace alphascope
