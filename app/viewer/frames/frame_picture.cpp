// SPDX-License-Identifier: GPL-3.0-or-later
// Brings the session's answers into the picture, and the picture into frames.
#include "app/viewer/frames/frame_picture.hpp"

#include <utility>

#include "app/viewer/mouse/gestures.hpp"
#include "app/viewer/session_text.hpp"

namespace alphascope {

void FramePicture::follow(const SessionChanges& changes) {
  const SessionState& s = p_.session.state();
  if (changes.answer && s.ours) {
    p_.scene.set_answer(s.ours);
    p_.state.device_text = s.ours->complex.engine.name + " on " + s.ours->complex.engine.device;
    p_.state.engine_note = s.ours->note;
  }
  if (s.prepared && !s.ours && !p_.session.activity().computing.busy) {
    p_.scene.show_without_answer();  // the computation was cancelled or has failed
  }
  if (changes.agreement && s.agreement) p_.scene.set_agreement(s.agreement);
}

void FramePicture::poll() {
  ViewState& state = p_.state;
  const auto molecule_before = p_.scene.drawn().molecule;
  must_draw_ |= p_.scene.poll();
  if (p_.scene.drawn().molecule != molecule_before) p_.due.ask_for_news();
  p_.scene.describe(state.viewport);
  if (state.result != p_.scene.drawn().answer) {
    state.result = p_.scene.drawn().answer;
    p_.due.ask_for_news();
    is_new_ = true;
  }
  const auto& ours = p_.session.state().ours;
  state.pending = ours && ours != state.result ? pending_text(*ours) : "";
}

// While the mouse turns the view, its movement is known only after the panels. A picture begun here
// would be drawn twice.
void FramePicture::begin() {
  const bool turned = !p_.state.viewport.events.empty();
  if (!patient_ && !turned) p_.scene.begin_picture(p_.state.viewport, interacting(p_.state));
}

void FramePicture::mark_outdated() {
  const SessionActivity a = p_.session.activity();
  p_.scene.set_pending((a.computing.unfinished() && !p_.session.state().up_to_date()) ||
                       (a.opening.unfinished() && a.opening_path.empty()));
}

// Software OpenGL draws with the same cores that make the tables. While a slider is dragged, one
// frame waits, so picture and tables appear together.
bool FramePicture::waits_for_tables() {
  if (patient_) return false;
  const bool is_new = std::exchange(is_new_, false);
  return is_new && p_.frame.in_software() && interacting(p_.state) &&
         p_.store.busy(Lane::interactive);
}

void FramePicture::draw(bool yields) {
  if (yields && !must_draw_ && p_.host.input().waiting()) return;
  must_draw_ = false;
  p_.scene.render(p_.state.viewport, interacting(p_.state), patient_);
}

}  // namespace alphascope
