// What a recording is of: a sweep of alpha, each frame a complex of its own, or a turntable, one
// complex from all around. Plain numbers; knows neither engine nor renderer.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "core/document/alpha/alpha_slider.hpp"
#include "core/document/commands/number_input.hpp"

namespace alphascope {

enum class RecordingKind : std::uint8_t { sweep, turntable };
// Of a turntable: upwards in the view, or an axis of the molecule's file.
enum class TurnAxis : std::uint8_t { up, x, y, z };

inline constexpr NumberRule kFramesRule{"The number of frames", 1, 20000, "", true};
inline constexpr NumberRule kFrameRateRule{"The frame rate", 1, 120, "/ s"};
inline constexpr NumberRule kTurnRule{"The turn", -36000, 36000, "°"};

// Of a lesson: how long a movie shows each step. Nothing moves meanwhile, so few frames do. As
// pictures, each step is one.
inline constexpr NumberRule kHoldRule{"The time of a step", 0.2, 600, "s"};
inline constexpr double kLessonFrameRate = 5;  // a second
int frames_held(double seconds);               // at that rate
// "lesson:10": seconds. Throws std::invalid_argument, a clause.
double read_lesson_recording(const std::string& text);

struct Recording {
  RecordingKind kind = RecordingKind::sweep;
  AlphaScaling scaling = AlphaScaling::linear;  // equal steps of alpha, its root, its logarithm
  double low = -1, high = 10;                   // Å², of the first and the last frame of a sweep
  double degrees = 360;  // of a turntable; positive: the molecule's front goes to the right
  TurnAxis axis = TurnAxis::up;
  int frames = 120;             // from one end to the other
  bool there_and_back = false;  // and then back, so that it can be shown in a loop
  double frames_per_second = 30;
  friend bool operator==(const Recording&, const Recording&) = default;
};

// Why it cannot be, and what can: a sentence; empty when it can.
std::string fault_of(const Recording& recording);

// Of the whole recording; those that follow are of such as have no fault, and of frames from 0 to
// this.
int frame_count(const Recording& recording);
// Å². Rounded to a power of ten that is less than a tenth of a step, so that it can be written
// whole; the ends are exact.
double alpha_of_frame(const Recording& recording, int frame);
// Around the axis. A turntable of whole turns that only goes there has no last frame like the
// first: it can be shown in a loop.
double degrees_of_frame(const Recording& recording, int frame);
double seconds_of(const Recording& recording);

// "alpha=-1:10:120" and "360:120": range or turn, and frames. Throws std::invalid_argument, a
// clause.
void read_sweep(const std::string& text, Recording& recording);
void read_turntable(const std::string& text, Recording& recording);

const char* turn_axis_id(TurnAxis axis);       // "up", "x"
const char* scaling_id(AlphaScaling scaling);  // "linear", "root", "log"
inline constexpr const char* kTurnAxes = "up|x|y|z";
inline constexpr const char* kScalings = "linear|root|log";
TurnAxis turn_axis_from_id(const std::string& id);    // of kTurnAxes
AlphaScaling scaling_from_id(const std::string& id);  // of kScalings

// A point turned about an axis of length 1 through a centre, right-handed.
std::array<double, 3> turned(const std::array<double, 3>& point,
                             const std::array<double, 3>& centre, const std::array<double, 3>& axis,
                             double degrees);

}  // namespace alphascope
