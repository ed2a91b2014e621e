// SPDX-License-Identifier: GPL-3.0-or-later
// All values that a user sets for the open file. Undo restores them, and session files hold them.
// The state of windows and dialogs is not included.
#pragma once

#include <string>

#include "core/document/reference/annotations.hpp"
#include "core/document/reference/appearance.hpp"
#include "core/document/reference/ref_set.hpp"
#include "core/document/settings/cavity_settings.hpp"
#include "core/document/settings/clip.hpp"
#include "core/document/settings/display.hpp"
#include "core/document/settings/drawn_object.hpp"
#include "core/document/settings/named_view.hpp"
#include "core/document/settings/open_options.hpp"
#include "core/document/settings/request.hpp"

namespace alphascope {

struct Settings {
  OpenOptions open;
  Request request;
  DisplaySettings display;
  DrawnObjects objects;  // of the molecule's atoms, in the order of their list
  Selection selection;   // in the picture, and in the table of cavities
  Clip clip;
  NamedClips clips;  // saved under names, in the order of saving
  NamedViews views;  // saved cameras, in the order of saving
  Appearance appearance;
  Annotations annotations;
  CavitySettings cavity_settings;
  friend bool operator==(const Settings&, const Settings&) = default;
};

// Names of the differences, for "Undo …": "alpha", "radii", "outlines", or several as "alpha and
// display". Empty if there are none.
std::string difference_text(const Settings& a, const Settings& b);

}  // namespace alphascope
