// SPDX-License-Identifier: GPL-3.0-or-later
// Applies preferences at the start, and notes the changes that the user makes in the window.
#include "app/viewer/parts/window_preferences.hpp"

#include <algorithm>
#include <cmath>

#include "core/document/reference/atom_set.hpp"
#include "core/document/settings/request.hpp"
#include "core/engine/cold_and_warm.hpp"
#include "core/geometry/ball_set.hpp"
#include "ui/panels/dialogs/browser_state.hpp"
#include "ui/panels/error_kind.hpp"
#include "ui/panels/window_settings.hpp"
#include "ui/theme.hpp"

namespace alphascope {
namespace {

// Factors of presenter mode. Lines grow more than letters, since a projector loses them first.
constexpr double kPresenterTimes = 1.5, kPresenterLines = 1.4;

}  // namespace

// Applies the preferences, unless an option of the command line says otherwise.
void WindowPreferences::begin_with(const ViewerOptions& options) {
  set_scale_ = options.scale;
  const Preferences& p = keeper_.now();
  const bool light = options.light || p.light_theme;
  state_.window.theme = light ? Theme::light : Theme::dark;
  state_.window.control_scale = options.scale > 0 ? options.scale : p.scale;
  state_.window.presenter_size = p.presenter_size;
  state_.window.page = state_.window.chosen_page = p.page;
  state_.window.glide = p.glide;
  std::error_code ignored;
  if (std::filesystem::is_directory(p.last_folder, ignored)) {
    state_.browser.folder = p.last_folder;
  }
  state_.recent = p.recent;
  if (needs_gpu(p.engine)) {
    engine_when_found_ = p.engine;
  } else {
    state_.settings.request.engine = p.engine;
  }
  noted_ = preferred();
}

// Returns the present values of all preferences. A minimised window has no size, and keeps the last
// one.
Preferences WindowPreferences::preferred() const {
  Preferences p = noted_;
  p.light_theme = state_.window.theme == Theme::light;
  p.scale = state_.window.control_scale;
  p.presenter_size = state_.window.presenter_size;
  p.page = state_.window.chosen_page;
  p.glide = state_.window.glide;
  p.engine = state_.settings.request.engine;
  p.last_folder = state_.browser.folder;
  const HostSize size = host_.size();
  if (size.width <= 0 || size.height <= 0) return p;  // minimised
  const auto at_scale_1 = [&size, this](int pixels) {
    constexpr long kLeast = 480, kMost = 16384;  // the limits of Preferences
    const float length = static_cast<float>(pixels) / size.scale * static_cast<float>(set_times_);
    return static_cast<int>(std::clamp(std::lround(length), kLeast, kMost));
  };
  p.width = at_scale_1(size.width);
  p.height = at_scale_1(size.height);
  return p;
}

// Notes changes by the user as preferences. Values from options or sessions are not noted.
void WindowPreferences::note() {
  const Preferences seen = preferred();
  if (seen == noted_) return;
  Preferences p = keeper_.now();
  const auto take = [&](auto Preferences::*field) {
    if (seen.*field != noted_.*field) p.*field = seen.*field;
  };
  take(&Preferences::light_theme);
  take(&Preferences::scale);
  take(&Preferences::presenter_size);
  take(&Preferences::page);
  take(&Preferences::glide);
  take(&Preferences::width);
  take(&Preferences::height);
  take(&Preferences::engine);
  take(&Preferences::last_folder);
  noted_ = seen;
  keeper_.set(p);
}

void WindowPreferences::note_recent_file(const std::filesystem::path& file) {
  Preferences p = keeper_.now();
  note_recent(p, file);
  keeper_.set(p);
  state_.recent = p.recent;
}

void WindowPreferences::forget_recent() {
  Preferences p = keeper_.now();
  p.recent.clear();
  keeper_.set(p);
  state_.recent.clear();
}

bool WindowPreferences::follow_scale() {
  const double times = state_.window.presenter_size ? kPresenterTimes : 1;
  if (state_.window.control_scale == set_scale_ && times == set_times_) return false;
  set_scale_ = state_.window.control_scale;
  set_times_ = times;
  host_.set_scale(set_scale_, set_times_);
  return true;
}

float WindowPreferences::line_scale(float scale) const {
  return scale * static_cast<float>(state_.window.presenter_size ? kPresenterLines : 1);
}

bool WindowPreferences::poll() {
  const std::string problem = keeper_.poll();
  if (problem.empty()) return false;
  state_.show_error("Preferences", problem, ErrorKind::output);
  return true;
}

void WindowPreferences::ignore_changes_so_far() {
  noted_ = preferred();
}

void WindowPreferences::take_gpu() {
  if (!engine_when_found_) return;
  state_.settings.request.engine = noted_.engine = *engine_when_found_;
}

}  // namespace alphascope
