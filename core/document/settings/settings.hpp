// Everything that a user sets for the open file, as plain values: what undo goes back to, and what
// a session file has to hold. Windows and dialogs are not here.
#pragma once

#include <string>

#include "core/document/reference/annotations.hpp"
#include "core/document/reference/appearance.hpp"
#include "core/document/reference/ref_set.hpp"
#include "core/document/settings/cavity_choices.hpp"
#include "core/document/settings/clip.hpp"
#include "core/document/settings/display.hpp"
#include "core/document/settings/named_view.hpp"
#include "core/document/settings/open_options.hpp"
#include "core/document/settings/request.hpp"

namespace alphascope {

struct Settings {
  OpenOptions open;
  Request request;
  DisplayControls display;
  Selection selection;  // in the picture, and in the table of cavities
  Clip clip;
  NamedViews views;  // saved cameras, in the order of saving
  Appearance appearance;
  Annotations annotations;
  CavityChoices cavity_choices;
  friend bool operator==(const Settings&, const Settings&) = default;
};

// What differs, for "Undo …": "alpha", "radii", "display"; several are "alpha and display". Empty
// when nothing does.
std::string difference_text(const Settings& a, const Settings& b);

}  // namespace alphascope
