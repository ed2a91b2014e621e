// SPDX-License-Identifier: GPL-3.0-or-later
// Decides when changed settings are sent. A moving slider waits for the results of its earlier
// values.
#include "app/viewer/frames/settings_sender.hpp"

#include "app/viewer/molecule_info.hpp"
#include "app/viewer/mouse/gestures.hpp"
#include "app/viewer/session_text.hpp"
#include "core/document/store/derived.hpp"
#include "core/selection/selection_expression.hpp"
#include "ui/panels/molecule/expression_state.hpp"
#include "ui/panels/window_settings.hpp"

namespace alphascope {
namespace {

// While the user moves a ball or the slider of models, the model that is being computed may finish.
// So pictures keep coming. The next request waits for it at most this long.
constexpr std::chrono::milliseconds kModelGrace{300};

}  // namespace

void SettingsSender::begin() {
  options_ = state_.settings.open;
  session_.set_request(canonical(state_.settings.request));
  session_.set_open_options(options_);
}

bool SettingsSender::request_is_sent() const {
  return canonical(state_.settings.request) == session_.state().request;
}

bool SettingsSender::settled() const {
  const SessionActivity a = session_.activity();
  return !a.opening.busy && !a.computing.busy && session_.state().up_to_date();
}

// While the solvent radius is dragged, the engine runs at most one step ahead of the tables of all
// balls. Otherwise the computations would take all cores, and the tables would fall behind.
bool SettingsSender::awaits_panels() const {
  const auto& ours = session_.state().ours;
  const bool other_balls = state_.settings.request.solvent_radius_angstrom !=
                           session_.state().request.solvent_radius_angstrom;
  const bool ahead =
      session_.activity().computing.busy || (ours && ours->balls != inputs_.now().balls);
  return other_balls && ahead && interacting(state_) && store_.busy(Lane::interactive);
}

void SettingsSender::send_request() {
  if (request_is_sent()) return;
  moves_.note_wanted(canonical(state_.settings.request));
  if (awaits_panels()) return;
  const Request& request = state_.settings.request;
  session_.set_request(canonical(request), results_for_all_alphas(store_, inputs_.now()));
  state_.compute_error.clear();  // the message was about another alpha
  const SessionState& s = session_.state();
  if (s.prepared) state_.molecule.radii = grown_radii(*s.prepared, request);
  due_.ask();
}

void SettingsSender::send_look(float line_scale) {
  scene_.set_display(state_.settings.display, state_.window.theme, line_scale);
  scene_.set_clip(state_.settings.clip);
  scene_.set_appearance(state_.settings.appearance);
  scene_.set_objects(state_.settings.objects);
}

void SettingsSender::send_selection() {
  OpenOptions& wanted = state_.settings.open;
  if (wanted.balls.selection != options_.balls.selection) {
    state_.expression_error = fault_of_selection(wanted.balls.selection);
    if (state_.expression_error) {
      wanted.balls.selection = options_.balls.selection;
      // The typed expression stays in its field, so that it can be corrected.
      state_.expression.shown = wanted.balls.selection;
    }
  }
  if (wanted == options_) return;
  OpenOptions as_frames = options_;  // these two may change in every frame
  as_frames.balls.model = wanted.balls.model;
  as_frames.sandbox = wanted.sandbox;
  const bool may_wait = wanted == as_frames && !settled() && state_.error.empty() &&
                        Clock::now() - options_sent_at_ < kModelGrace;
  if (may_wait) return;
  // Copies of chains have other names in another assembly, and copies of models hold other atoms.
  if (wanted.assembly != options_.assembly) wanted.balls.without_chains.clear();
  options_ = wanted;
  options_sent_at_ = Clock::now();
  session_.set_open_options(wanted);
  due_.ask();
}

void SettingsSender::take_options() {
  options_ = session_.open_options();
  state_.settings.open = options_;
}

}  // namespace alphascope
