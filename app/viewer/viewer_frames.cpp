// SPDX-License-Identifier: GPL-3.0-or-later
// The frames of the window: when each is drawn, and in what order its work is done.
#include <imgui.h>

#include <algorithm>
#include <optional>

#include "app/viewer/mouse/gestures.hpp"
#include "app/viewer/viewer.hpp"
#include "ui/panels/frame/window_layout.hpp"
#include "ui/scene/picture/frame_grab.hpp"

namespace alphascope {

void Viewer::act() {
  for (const PointerEvent& event : state_.viewport.events) {
    if (event.kind == PointerEvent::Kind::double_click) {
      history_.move_view([&] { pointing_.centre_on_it(event); });
    } else if (event.kind == PointerEvent::Kind::click) {
      pointing_.click(event);
    } else {
      continue;
    }
    pace_.due().ask();
  }
  run_calls();
  lessons_.player().step();
  saving_.go_on_recording(!working_except_saving() && !store_.busy());
  playing_.step(sender_.settled() && sender_.options_are_sent());
  send_controls();
  preferences_.note();
}

// A glide ends where time is short or a user goes on. Scripts, lessons and recordings show the same
// pictures everywhere, so they jump.
void Viewer::move_camera(bool scripted) {
  Cameras& cameras = scene_.cameras();
  const bool by_itself = scripted || lessons_.plays() || saving_.sweeps();
  // With fewer than three pictures a glide is a flicker.
  constexpr double kMostMilliseconds = 100;
  const bool quick = scene_.shown().pacing().moving_milliseconds() <= kMostMilliseconds;
  cameras.set_glides(state_.window.glide && !by_itself && quick);
  if (cameras.gliding() && anything_pressed()) cameras.end_glide();
  cameras.step_glide();
}

void Viewer::draw(ScriptedInput* input, const std::function<void(unsigned)>& before_swap) {
  pace_.begin_frame();
  jobs_.list().describe();
  status_.update_background();
  messages_.follow();
  if (preferences_.follow_scale()) pace_.due().ask();
  guarded([this] { pointing_.describe_under_mouse(); });
  if (!frame_.begin(state_.window.theme, input)) {
    scene_.cameras().end_glide();  // nobody sees it
    return inputs_.want_results_for_all_alphas();
  }
  session_.set_dragging(interacting(state_));
  session_.set_measuring(state_.measures_wanted ||
                         is_exposure(state_.settings.display.ball_paint.by));
  session_.set_finding_outer_faces(scene_.draws_outer_faces());
  history_.begin_frame();
  move_camera(input != nullptr);
  store_.next_frame();
  const auto begin_picture = [this] {
    session_.set_tables_first(interacting(state_) && store_.busy(Lane::interactive));
    sender_.send_request();
    picture_.begin();
  };
  // Tables of new balls take longer than their picture. So while a slider or a ball is dragged, the
  // panels ask for them first.
  const bool tables_first = inputs_.took_balls() && interacting(state_);
  if (!tables_first) guarded(begin_picture);
  const Calls calls = this->calls();
  const WindowParts parts{state_, rects_, commands_, store_, inputs_.now(), calls, panels_};
  draw_window(parts, frame_.fonts(), frame_.scale());
  guarded([this] { inputs_.want_results_for_all_alphas(); });
  if (tables_first) guarded(begin_picture);
  guarded([this] {
    const std::optional<CameraPlace> before = scene_.cameras().place();
    if (pointing_.move_view()) history_.note_view_moved(before);
  });
  guarded([this] { act(); });
  guarded([this] {
    marks_.mark_selection();
    marks_.draw_annotations();
    scene_.shown().layers().set(state_.layers);
  });
  picture_.mark_outdated();
  const bool undrawn = picture_.waits_for_tables();
  if (!undrawn) guarded([&] { picture_.draw(input == nullptr); });
  pointing_.place_clip_handle();
  draw_over_picture(parts, frame_.fonts(), frame_.scale());
  if (undrawn) return frame_.end_undrawn();
  if (before_swap) {
    frame_.end(before_swap);
  } else {
    frame_.end();
  }
  memory_.give_back_when_due(busy());
}

void Viewer::step(ScriptedInput* input) {
  host_.wait_events(0);
  take_results();
  draw(input);
}

void Viewer::finish_frame() {
  frame_.finish();
  scene_.note_finished();
}

void Viewer::shoot(const std::filesystem::path& path, ScriptedInput* input) {
  const HostSize size = host_.size();
  picture_.set_patient(true);
  for (int i = 0; i < DueFrames::kSettling; ++i) step(input);
  draw(input, [&](unsigned framebuffer) {
    Image image = read_framebuffer(framebuffer, size.width, size.height);
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) image.rgba[i] = 255;
    write_png(image, path, scene_.texts());
  });
  picture_.set_patient(false);
}

void Viewer::take_results() {
  guarded([this] {
    take_session();
    picture_.poll();
    inputs_.follow_picture();
    memory_.note_freed(jobs_.list().poll());
    status_.compare_when_due(interacting(state_));
  });
}

// While software OpenGL draws and a computation runs, fewer frames leave cores to the computation.
bool Viewer::wait_for_frame() {
  const auto wait = [this] {
    return pace_.seconds_to_next_frame(frame_.in_software() && (working() || store_.busy()));
  };
  bool events = false;
  for (double seconds = wait(); seconds > 0; seconds = wait()) {
    if (!host_.wait_events(seconds)) continue;
    events = true;
    take_results();
  }
  return events;
}

bool Viewer::frame_is_due() const {
  const bool playing = state_.playback.alpha || state_.playback.models;
  const bool step_due = state_.steps.playing && playing_.seconds_to_next_step() <= 0;
  return pace_.due().any() || playing || step_due || working() || store_.busy() ||
         scene_.wants_frame() || scene_.cameras().gliding() || !sender_.options_are_sent();
}

void Viewer::run() {
  while (!quit_requested() && !host_.close_requested()) {
    const bool behind = host_.input().waiting();
    double soonest = std::min(scene_.seconds_to_refinement(), playing_.seconds_to_next());
    if (scene_.cameras().gliding()) soonest = 0;
    bool events = host_.wait_events(behind ? 0 : pace_.idle_seconds(working(), soonest)) || behind;
    events |= wait_for_frame();
    pace_.note_wait(events);
    guarded([this] { open_dropped(host_.take_dropped_files()); });
    take_results();
    if (!frame_is_due()) continue;
    pace_.due().count_down();
    draw(nullptr);
  }
  host_.hide();
}

}  // namespace alphascope
