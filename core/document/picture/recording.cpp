// SPDX-License-Identifier: GPL-3.0-or-later
// Frames of sweeps, turntables and lessons, and their texts on the command line.
#include "core/document/picture/recording.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "core/geometry/shortest_number.hpp"

namespace alphascope {
namespace {

bool within(double value, const NumberRule& rule) {
  return value >= rule.least && value <= rule.most;
}

std::string range_text(const NumberRule& rule) {
  return shortest_number(rule.least) + " to " + shortest_number(rule.most);
}

// Position of a frame, from 0 at one end to 1 at the other. `open`: the other end is not reached.
double place_of_frame(const Recording& r, int frame, bool open) {
  const int step = frame < r.frames ? frame : 2 * (r.frames - 1) - frame;
  const int steps = open ? r.frames : r.frames - 1;
  return steps > 0 ? static_cast<double>(step) / steps : 0;
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == ':') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

double number_of(const std::string& text, const std::string& whole) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [last, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || last != end || !std::isfinite(value)) {
    throw std::invalid_argument("\"" + text + "\" in \"" + whole + "\" is not a number");
  }
  return value;
}

int frames_of(const std::string& text, const std::string& whole) {
  const double frames = number_of(text, whole);
  if (!within(frames, kFramesRule) || frames != std::floor(frames)) {
    throw std::invalid_argument("the number of frames is a whole number from " +
                                range_text(kFramesRule) + ", not " + text);
  }
  return static_cast<int>(frames);
}

void require_no_fault(const Recording& recording) {
  std::string fault = fault_of(recording);
  if (fault.empty()) return;
  fault.pop_back();  // the full stop
  throw std::invalid_argument(fault);
}

}  // namespace

std::string fault_of(const Recording& r) {
  if (!within(r.frames, kFramesRule)) {
    return "The number of frames must be from " + range_text(kFramesRule) + ".";
  }
  if (!within(r.frames_per_second, kFrameRateRule)) {
    return "The frame rate must be from " + range_text(kFrameRateRule) + " a second.";
  }
  if (r.kind == RecordingKind::turntable) {
    if (within(r.degrees, kTurnRule) && r.degrees != 0) return {};
    return "The turn must be from " + range_text(kTurnRule) + " degrees, and not 0.";
  }
  if (!within(r.low, kAlphaRule) || !within(r.high, kAlphaRule)) {
    return "Alpha must be from " + range_text(kAlphaRule) + " Å².";
  }
  if (r.low == r.high) {
    return "The sweep must go from one alpha to a larger one, not from " + shortest_number(r.low) +
           " to " + shortest_number(r.high) + " Å².";
  }
  if (r.low > r.high) {
    return "The sweep must go from the smaller alpha to the larger one: from " +
           shortest_number(r.high) + " to " + shortest_number(r.low) +
           " Å² instead, or there and back for both ways.";
  }
  return {};
}

int frame_count(const Recording& r) {
  return r.there_and_back && r.frames > 1 ? 2 * (r.frames - 1) : r.frames;
}

double alpha_of_frame(const Recording& r, int frame) {
  const AlphaSlider slider{.scaling = r.scaling, .low = r.low, .high = r.high};
  const double tenth_of_a_step = r.frames > 1 ? 0.1 / (r.frames - 1) : 0.1;
  return alpha_at_slider_position(slider, place_of_frame(r, frame, false), tenth_of_a_step);
}

double degrees_of_frame(const Recording& r, int frame) {
  constexpr double kWholeTurn = 360;
  const bool closes = std::fmod(r.degrees, kWholeTurn) == 0 && !r.there_and_back;
  return r.degrees * place_of_frame(r, frame, closes);
}

double seconds_of(const Recording& r) {
  return frame_count(r) / r.frames_per_second;
}

void read_sweep(const std::string& text, Recording& recording) {
  constexpr const char* kName = "alpha=";
  const std::vector<std::string> parts = split(text);
  if (!text.starts_with(kName) || parts.size() != 3) {
    throw std::invalid_argument("a sweep is alpha=FROM:TO:FRAMES, such as alpha=-1:10:120, not \"" +
                                text + "\"");
  }
  recording.kind = RecordingKind::sweep;
  recording.low = number_of(parts[0].substr(std::string(kName).size()), text);
  recording.high = number_of(parts[1], text);
  recording.frames = frames_of(parts[2], text);
  require_no_fault(recording);
}

void read_turntable(const std::string& text, Recording& recording) {
  const std::vector<std::string> parts = split(text);
  if (parts.size() != 2) {
    throw std::invalid_argument("a turntable is DEGREES:FRAMES, such as 360:120, not \"" + text +
                                "\"");
  }
  recording.kind = RecordingKind::turntable;
  recording.degrees = number_of(parts[0], text);
  recording.frames = frames_of(parts[1], text);
  require_no_fault(recording);
}

int frames_held(double seconds) {
  return std::max(1, static_cast<int>(std::lround(seconds * kLessonFrameRate)));
}

double read_lesson_recording(const std::string& text) {
  const std::vector<std::string> parts = split(text);
  if (parts.size() != 2 || parts[0] != "lesson") {
    throw std::invalid_argument("a lesson is lesson:SECONDS, such as lesson:10, not \"" + text +
                                "\"");
  }
  const double seconds = number_of(parts[1], text);
  if (!within(seconds, kHoldRule)) {
    throw std::invalid_argument("a step is shown for " + range_text(kHoldRule) + " s, not for " +
                                parts[1]);
  }
  return seconds;
}

const char* turn_axis_id(TurnAxis axis) {
  constexpr const char* kIds[] = {"up", "x", "y", "z"};
  return kIds[static_cast<int>(axis)];
}

const char* scaling_id(AlphaScaling scaling) {
  constexpr const char* kIds[] = {"linear", "root", "log"};
  return kIds[static_cast<int>(scaling)];
}

TurnAxis turn_axis_from_id(const std::string& id) {
  for (const TurnAxis axis : {TurnAxis::x, TurnAxis::y, TurnAxis::z}) {
    if (id == turn_axis_id(axis)) return axis;
  }
  return TurnAxis::up;
}

AlphaScaling scaling_from_id(const std::string& id) {
  for (const AlphaScaling scaling : {AlphaScaling::root, AlphaScaling::logarithm}) {
    if (id == scaling_id(scaling)) return scaling;
  }
  return AlphaScaling::linear;
}

// By Rodrigues' formula.
std::array<double, 3> turned(const std::array<double, 3>& point,
                             const std::array<double, 3>& centre, const std::array<double, 3>& axis,
                             double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  const double c = std::cos(angle), s = std::sin(angle);
  const std::array<double, 3> v{point[0] - centre[0], point[1] - centre[1], point[2] - centre[2]};
  const double along = axis[0] * v[0] + axis[1] * v[1] + axis[2] * v[2];
  std::array<double, 3> result{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const double across = axis[i] * v[j] - axis[j] * v[i];
    result[k] = centre[k] + c * v[k] + s * across + (1 - c) * along * axis[k];
  }
  return result;
}

}  // namespace alphascope
