// The frames of the window: when each is drawn, and in what order its work is done.
#include <imgui.h>

#include <algorithm>

#include "app/viewer/viewer.hpp"
#include "ui/panels/frame/window_layout.hpp"
#include "ui/scene/picture/frame_grab.hpp"

namespace alphascope {
namespace {

// A tooltip appears when the mouse rests. This is no event, so a frame is drawn for it after this
// time. ImGui measures a tooltip in its first frame and hides it there.
constexpr std::chrono::milliseconds kTooltipFrameAfter{450};
static_assert(kTooltipFrameAfter.count() > 1000 * kTooltipDelaySeconds);
constexpr double kBusyInterval = 0.05, kIdleInterval = 1.0;  // seconds

}  // namespace

bool Viewer::interacting() const {
  const ImGuiIO& io = ImGui::GetIO();
  return state_.playback.alpha || state_.playback.models || io.MouseDown[0] || io.MouseDown[1] ||
         io.MouseDown[2];
}

void Viewer::draw(ScriptedInput* input, bool patient,
                  const std::function<void(unsigned)>& before_swap) {
  frame_begun_at_ = Clock::now();
  news_ = false;
  status_.update_busy(opening_.reading());
  if (preferences_.follow_scale()) due_.ask();
  guarded([this] { pointing_.describe_under_mouse(); });
  if (!frame_.begin(state_.window.theme, input)) return want_of_all_balls();
  session_.let_finish(interacting());
  session_.set_measuring(state_.measures_wanted ||
                         is_exposure(state_.settings.display.ball_paint.by));
  session_.set_finding_outside(scene_.draws_outside());
  history_.begin_frame();
  store_.next_frame();
  guarded([&] {
    send_compute();
    // While the mouse turns the view, its movement is known only after the panels. A picture begun
    // here would be drawn twice.
    const bool turned = !state_.viewport.events.empty();
    if (!patient && !turned) scene_.begin_picture(state_.viewport, interacting());
  });
  const Calls calls = this->calls();
  const WindowParts parts{state_, rects_, commands_, store_, inputs_, calls, panels_};
  draw_window(parts, frame_.fonts(), frame_.scale());
  guarded([this] { want_of_all_balls(); });
  guarded([this] {
    const std::optional<CameraPlace> before = scene_.camera();
    for (const PointerEvent& event : state_.viewport.events) {
      if (!pointing_.drag_ball(event)) scene_.pointer(event);
    }
    if (scene_.camera() != before) history_.note_view_moved();
  });
  guarded([this] {
    for (const PointerEvent& event : state_.viewport.events) {
      if (event.kind != PointerEvent::Kind::click) continue;
      pointing_.click(event);
      due_.ask();
    }
    run_calls();
    lessons_.step();
    saving_.go_on_recording(!all_but_saving() && !store_.busy());
    playing_.step(settled() && state_.settings.open == sent_open_);
    send_controls();
    preferences_.note();
  });
  guarded([this] {
    marks_.mark_selection();
    marks_.draw_annotations();
    scene_.set_layers(state_.layers);
  });
  // Draws the scene after the panels, so that the picture has this frame's size, and before ImGui
  // shows it. A frame with waiting input draws no scene: slow pictures would delay the window.
  const SessionActivity a = session_.activity();
  scene_.set_pending((a.computing.unfinished() && !session_.state().up_to_date()) ||
                     (a.opening.unfinished() && a.opening_path.empty()));
  const bool undrawn = !patient && waits_for_tables();
  if (!undrawn && (input != nullptr || must_render_ || !host_.input().waiting())) {
    must_render_ = false;
    guarded([&] { scene_.render(state_.viewport, interacting(), patient); });
  }
  pointing_.place_clip_handle();
  draw_over_picture(parts, frame_.fonts(), frame_.scale());
  if (undrawn) return frame_.end_undrawn();
  if (draw_shots_only_ && !before_swap) {
    frame_.end_undrawn();
    return give_back_memory_when_due();
  }
  frame_.end([&](unsigned framebuffer) {
    if (before_swap) before_swap(framebuffer);
  });
  give_back_memory_when_due();
}

void Viewer::step(ScriptedInput* input) {
  host_.wait_events(0);
  take_results();
  draw(input, patient_);
}

void Viewer::finish_frame() {
  frame_.finish();
  scene_.note_finished();
}

void Viewer::shoot(const std::filesystem::path& path, ScriptedInput* input) {
  const HostSize size = host_.size();
  patient_ = true;
  for (int i = 0; i < DueFrames::kSettling; ++i) step(input);
  draw(input, true, [&](unsigned framebuffer) {
    Image image = read_framebuffer(framebuffer, size.width, size.height);
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) image.rgba[i] = 255;
    write_png(image, path, scene_.texts());
  });
  patient_ = false;
}

double Viewer::idle_seconds() const {
  if (due_.any()) return 0;
  const double idle = working() ? kBusyInterval : kIdleInterval;
  double wait = std::min(idle, scene_.seconds_to_refinement());
  wait = std::min(wait, playing_.seconds_to_next());
  if (tooltip_due_) {
    wait = std::min(wait, std::chrono::duration<double>(*tooltip_due_ - Clock::now()).count());
  }
  return std::max(0.001, wait);
}

// While software OpenGL draws and a computation runs, fewer frames leave cores to the computation.
double Viewer::seconds_to_next_frame() const {
  constexpr double kMostFrames = 60, kWhileComputing = 25;  // a second
  if (news_) return 0;
  const bool yields = frame_.in_software() && (working() || store_.busy());
  const std::chrono::duration<double> since = Clock::now() - frame_begun_at_;
  return 1 / (yields ? kWhileComputing : kMostFrames) - since.count();
}

void Viewer::take_results() {
  guarded([this] {
    take_session();
    take_shown();
    take_derived();
    status_.compare_when_due(interacting());
  });
}

bool Viewer::wait_for_frame() {
  bool events = false;
  for (double wait = seconds_to_next_frame(); wait > 0; wait = seconds_to_next_frame()) {
    if (!host_.wait_events(wait)) continue;
    events = true;
    take_results();
  }
  return events;
}

void Viewer::run() {
  while (!quit_ && !host_.close_requested()) {
    const bool behind = host_.input().waiting();
    bool events = host_.wait_events(behind ? 0 : idle_seconds()) || behind;
    events |= wait_for_frame();
    if (events) {
      due_.ask();
      tooltip_due_ = Clock::now() + kTooltipFrameAfter;
    } else if (tooltip_due_ && Clock::now() >= *tooltip_due_) {
      due_.ask();
      tooltip_due_.reset();
    }
    guarded([this] { opening_.open_dropped(host_.take_dropped_files()); });
    take_results();
    const bool playing = state_.playback.alpha || state_.playback.models;
    const bool step_due = state_.steps.playing && playing_.seconds_to_next_step() <= 0;
    const bool due = due_.any() || playing || step_due || working() || store_.busy() ||
                     scene_.wants_frame() || state_.settings.open != sent_open_;
    if (!due) continue;
    due_.count = std::max(0, due_.count - 1);
    draw(nullptr, false);
  }
  host_.hide();
}

}  // namespace alphascope
