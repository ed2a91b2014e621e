// SPDX-License-Identifier: GPL-3.0-or-later
// The dialog that records a sweep of alpha, a turntable or the open lesson. The ending of the name
// decides whether pictures or a movie are written.
#include <imgui.h>

#include <optional>
#include <stdexcept>

#include "core/document/alpha/alpha_slider.hpp"
#include "core/document/export/program_name.hpp"
#include "core/document/lessons/lesson.hpp"
#include "core/document/picture/frame_names.hpp"
#include "core/document/picture/recording.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/run/cancel_token.hpp"
#include "core/run/child_program.hpp"
#include "core/text/as_sentence.hpp"
#include "ui/calls.hpp"
#include "ui/number_text.hpp"
#include "ui/panels/dialogs/dialog_stack.hpp"
#include "ui/panels/dialogs/fields/picture_fields.hpp"
#include "ui/panels/dialogs/fields/typed_path.hpp"
#include "ui/panels/dialogs/picture_requests.hpp"
#include "ui/panels/dialogs/save_target.hpp"
#include "ui/panels/lessons/lesson_state.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/panels/window_settings.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/number_field.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;

constexpr float kWidth = 464;  // pixels at scale 1
constexpr float kNumberWidth = 80;

constexpr const char* kNoFfmpeg =
    "Movies need the program ffmpeg, which is not installed (Debian: apt install ffmpeg). "
    "Pictures need no other program.";

void error_lines(PanelContext& ctx, const char* name, const std::string& text) {
  two_small_lines(ctx, name, ctx.palette.error, as_sentence(text));
}

// Returns the format by the name's ending. If there is none, or no place for numbers, `why_not`
// says so.
std::optional<RecordingFormat> format_of(const fs::path& path, std::string& why_not) {
  try {
    const RecordingFormat format = recording_format(path);
    if (format == RecordingFormat::frames) FrameNames{path};
    return format;
  } catch (const std::invalid_argument& error) {
    why_not = error.what();
    return std::nullopt;
  }
}

void choose_format(PanelContext& ctx, std::optional<RecordingFormat> format) {
  RecordState& m = ctx.state.record;
  int chosen = format ? static_cast<int>(*format) : -1;
  row_label(ctx, "Format");
  if (!choice(ctx, "record.format", {"Pictures", "MP4 movie", "WebM movie"}, chosen, ctx.px(300))) {
    return;
  }
  const fs::path path = m.path;
  std::string stem = path.stem().string();
  if (const std::size_t place = stem.find("-%"); place != std::string::npos) stem.resize(place);
  if (stem.empty() || stem.find('%') != std::string::npos) stem = "frame";
  constexpr const char* kEndings[] = {"-%04d.png", ".mp4", ".webm"};
  m.path = (path.parent_path() / (stem + kEndings[chosen])).string();
}

// Draws the rows for file and format. Returns whether the recording can be written there.
bool target(PanelContext& ctx) {
  RecordState& m = ctx.state.record;
  const fs::path path = typed_path(m.path);
  std::string why_not;
  const std::optional<RecordingFormat> format = format_of(path, why_not);
  const bool frames = format == RecordingFormat::frames;
  if (!m.has_ffmpeg) m.has_ffmpeg = find_program("ffmpeg").has_value();
  const bool has_place =
      save_target(ctx, "record", {frames ? FrameNames(path).name(1) : path}, why_not);
  choose_format(ctx, format);
  if (format && !frames && !*m.has_ffmpeg) {
    error_lines(ctx, "record.no_ffmpeg", kNoFfmpeg);
  } else if (format == RecordingFormat::mp4 && m.options.background.transparent && !m.of_lesson) {
    error_lines(ctx, "record.opaque", "MP4 movies have a background; choose WebM or pictures");
  } else {
    error_lines(ctx, "", "");
    return has_place;
  }
  return false;
}

void sweep_fields(PanelContext& ctx, Recording& r) {
  row_label(ctx, "Alpha");
  ImGui::SetNextItemWidth(ctx.px(kNumberWidth));
  number_field(ctx, "record.low", r.low, kAlphaRule);
  ImGui::SameLine(0, ctx.px(6));
  ImGui::TextUnformatted("to");
  ImGui::SameLine(0, ctx.px(6));
  ImGui::SetNextItemWidth(ctx.px(kNumberWidth));
  number_field(ctx, "record.high", r.high, kAlphaRule);
  ImGui::SameLine(0, ctx.px(6));
  ImGui::TextUnformatted("Å²");
  ImGui::SameLine(0, ctx.px(12));
  if (button(ctx, "record.as_slider", "as the slider")) {
    const AlphaSlider& slider = ctx.state.window.alpha_slider;
    r.low = slider.low;
    r.high = slider.high;
    r.scaling = slider.scaling;
  }
  row_label(ctx, "Steps");
  int scaling = static_cast<int>(r.scaling);
  if (choice(ctx, "record.scaling", {"Even", "Square root", "Logarithm"}, scaling, ctx.px(300))) {
    r.scaling = static_cast<AlphaScaling>(scaling);
  }
  tooltip(ctx, "Equal steps of alpha, of its signed square root, or of its logarithm.");
}

void turntable_fields(PanelContext& ctx, Recording& r) {
  row_label(ctx, "Turn by");
  ImGui::SetNextItemWidth(ctx.px(kNumberWidth));
  number_field(ctx, "record.degrees", r.degrees, kTurnRule);
  ImGui::SameLine(0, ctx.px(6));
  ImGui::TextUnformatted("°, from the present view");
  row_label(ctx, "About");
  int axis = static_cast<int>(r.axis);
  if (choice(ctx, "record.axis", {"Up", "x", "y", "z"}, axis, ctx.px(300))) {
    r.axis = static_cast<TurnAxis>(axis);
  }
  tooltip(ctx,
          "Upward axis of the view, or an axis of the file, through the centre of rotation. "
          "The camera keeps its distance.");
}

void time_fields(PanelContext& ctx, Recording& r) {
  row_label(ctx, "Frames");
  ImGui::SetNextItemWidth(ctx.px(kNumberWidth));
  number_field(ctx, "record.frames", r.frames, kFramesRule);
  ImGui::SameLine(0, ctx.px(6));
  ImGui::TextUnformatted("at");
  ImGui::SameLine(0, ctx.px(6));
  ImGui::SetNextItemWidth(ctx.px(50));
  number_field(ctx, "record.fps", r.frames_per_second, kFrameRateRule);
  ImGui::SameLine(0, ctx.px(6));
  const std::string seconds = number_text(seconds_of(r), 1);
  ImGui::TextUnformatted(("a second: " + seconds + " s").c_str());
  row_label(ctx, "");
  checkbox(ctx, "record.there_and_back", "There and back", r.there_and_back);
  tooltip(ctx, "Plays back to the beginning, so that the movie can run in a loop.");
}

void lesson_fields(PanelContext& ctx) {
  RecordState& m = ctx.state.record;
  const auto& lesson = ctx.state.lessons.open;
  row_label(ctx, "Each step");
  ImGui::SetNextItemWidth(ctx.px(kNumberWidth));
  number_field(ctx, "record.seconds", m.lesson_seconds, kHoldRule);
  ImGui::SameLine(0, ctx.px(6));
  const auto parts = lesson ? static_cast<int>(count_of_parts(*lesson)) : 0;
  const double seconds = frames_held(m.lesson_seconds) / kLessonFrameRate * parts;
  ImGui::TextUnformatted(("s: " + number_text(seconds, 1) + " s as a movie").c_str());
  tooltip(ctx,
          "In a movie, the time for which each step and each answer is shown. As pictures, each is "
          "one file. The text is beside the view.");
  // Rows that other kinds have in addition; the dialog keeps its size.
  constexpr int kRowsOfOthers = 3;
  for (int n = 0; n < kRowsOfOthers; ++n) ImGui::Dummy({0, ImGui::GetFrameHeight()});
  error_lines(ctx, "record.no_lesson", lesson ? "" : "Open a lesson first: Help, Lessons…");
}

// Draws the choice of sweep, turntable or lesson, and the fields of the chosen one.
void kind_fields(PanelContext& ctx) {
  RecordState& m = ctx.state.record;
  int kind = m.of_lesson ? 2 : static_cast<int>(m.recording.kind);
  row_label(ctx, "Of");
  if (choice(ctx, "record.kind", {"Sweep of alpha", "Turntable", "Lesson"}, kind, ctx.px(300))) {
    m.of_lesson = kind == 2;
    if (!m.of_lesson) m.recording.kind = static_cast<RecordingKind>(kind);
  }
  if (m.of_lesson) return lesson_fields(ctx);
  if (m.recording.kind == RecordingKind::sweep) {
    sweep_fields(ctx, m.recording);
  } else {
    turntable_fields(ctx, m.recording);
  }
  time_fields(ctx, m.recording);
  error_lines(ctx, "record.fault", fault_of(m.recording));
}

bool is_there(const ViewState& s) {
  const RecordState& m = s.record;
  if (m.of_lesson) return s.lessons.open != nullptr;
  return fault_of(m.recording).empty() &&
         (m.recording.kind == RecordingKind::turntable || s.result);
}

}  // namespace

void draw_record(PanelContext& ctx) {
  ViewState& s = ctx.state;
  RecordState& m = s.record;
  constexpr const char* kTitle = "Record";
  propose_file(ctx, kTitle, "record", m.path, name_of_file(ctx, "-%04d.png"));
  if (!begin_dialog(ctx, kTitle)) return;
  const bool entered = file_row(ctx, "record", m.path);
  const bool can_write = target(ctx);
  kind_fields(ctx);
  size_fields(ctx, "record", m.options);
  ImGui::BeginDisabled(m.of_lesson);
  background_fields(ctx, "record", m.options);
  ImGui::EndDisabled();
  marks_fields(ctx, "record", m.options);
  ImGui::Dummy({0, ctx.px(6)});
  ImGui::NewLine();
  const bool can_record = can_write && is_there(s);
  const DialogAnswer answer = dialog_buttons(ctx, ctx.px(kWidth), {"record.cancel", "Cancel"},
                                             {"record.ok", "Record"}, can_record, entered);
  const bool confirmed = answer == DialogAnswer::confirm;
  if (confirmed) {
    RecordRequest request{typed_path(m.path), m.recording, m.options};
    if (m.of_lesson) request.lesson_seconds = m.lesson_seconds;
    ctx.calls.jobs.record(request);
  }
  if (confirmed || answer == DialogAnswer::cancel) {
    note_file(ctx, "record", m.path);
    m.show = false;
    m.has_ffmpeg.reset();
  }
  end_dialog(ctx);
}

}  // namespace alphascope
