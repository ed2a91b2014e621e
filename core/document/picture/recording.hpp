// SPDX-License-Identifier: GPL-3.0-or-later
// Describes a recording: a sweep of alpha (each frame is another complex) or a turntable (one
// complex from all sides). Plain numbers; knows neither engine nor renderer.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "core/document/alpha/alpha_slider.hpp"
#include "core/document/commands/number_input.hpp"

namespace alphascope {

enum class RecordingKind : std::uint8_t { sweep, turntable };
// Axis of a turntable: upwards in the view, or an axis of the molecule's file.
enum class TurnAxis : std::uint8_t { up, x, y, z };

inline constexpr NumberRule kFramesRule{"The number of frames", 1, 20000, "", true};
inline constexpr NumberRule kFrameRateRule{"The frame rate", 1, 120, "/ s"};
inline constexpr NumberRule kTurnRule{"The turn", -36000, 36000, "°"};

// Duration of each step of a lesson in a movie. Nothing moves during it, so few frames are enough.
// As pictures, each step is a single one.
inline constexpr NumberRule kHoldRule{"The time of a step", 0.2, 600, "s"};
inline constexpr double kLessonFrameRate = 5;  // frames a second
int frames_held(double seconds);               // number of frames at that rate, at least 1
// Reads "lesson:10" and returns the seconds. Throws std::invalid_argument with a clause.
double read_lesson_recording(const std::string& text);

struct Recording {
  RecordingKind kind = RecordingKind::sweep;
  AlphaScaling scaling = AlphaScaling::linear;  // equal steps of alpha, of its square root or of
                                                // its logarithm
  double low = -1, high = 10;                   // Å², at the first and last frame of a sweep
  double degrees = 360;  // of a turntable; positive: the front of the molecule moves right
  TurnAxis axis = TurnAxis::up;
  int frames = 120;             // from one end to the other
  bool there_and_back = false;  // then back again, so that the movie can run in a loop
  double frames_per_second = 30;
  friend bool operator==(const Recording&, const Recording&) = default;
};

// The reason why the recording is impossible, with a remedy, as a sentence; empty if it is
// possible.
std::string fault_of(const Recording& recording);

// Number of frames of the whole recording. This and the next functions require a recording without
// fault. Frames count from 0.
int frame_count(const Recording& recording);
// Alpha of a frame, Å². It is rounded to a multiple of a power of ten below a tenth of a step. So
// alpha has few digits. The ends are exact.
double alpha_of_frame(const Recording& recording, int frame);
// Angle of a frame about the axis. If a turntable makes whole turns in one direction, the last
// frame is not a copy of the first. So the movie can run in a loop.
double degrees_of_frame(const Recording& recording, int frame);
double seconds_of(const Recording& recording);

// Read "alpha=-1:10:120" and "360:120": range or angle, and the number of frames. Throw
// std::invalid_argument with a clause.
void read_sweep(const std::string& text, Recording& recording);
void read_turntable(const std::string& text, Recording& recording);

const char* turn_axis_id(TurnAxis axis);       // "up", "x"
const char* scaling_id(AlphaScaling scaling);  // "linear", "root", "log"
inline constexpr const char* kTurnAxes = "up|x|y|z";
inline constexpr const char* kScalings = "linear|root|log";
TurnAxis turn_axis_from_id(const std::string& id);    // `id` is one of kTurnAxes
AlphaScaling scaling_from_id(const std::string& id);  // `id` is one of kScalings

// A point turned about an axis (unit vector) through `centre`; right-handed.
std::array<double, 3> turned(const std::array<double, 3>& point,
                             const std::array<double, 3>& centre, const std::array<double, 3>& axis,
                             double degrees);

}  // namespace alphascope
