// SPDX-License-Identifier: GPL-3.0-or-later
// Repeats moves of alpha or of a ball in the window, and takes their times.
#include "app/viewer/script/timed_moves.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>
#include <stdexcept>
#include <vector>

#include "app/viewer/viewer.hpp"
#include "core/document/settings/request.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/sandbox.hpp"
#include "core/run/picture_stages.hpp"

namespace alphascope {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kLongest{300};
// Å²; moves start this far from the target, at a complex of about the same size
constexpr double kBeside = 0.05;
// Moves that are not counted. They allocate the memory for the results.
constexpr int kWarmUp = 2;
constexpr double kStep = 0.0371;  // Å, length of a ball's move

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

class Mover {
 public:
  Mover(Viewer& viewer, ScriptedInput& input) : viewer_(viewer), input_(input) {}

  // Milliseconds until the picture of this alpha is drawn.
  double move_to(double angstrom2) {
    const Clock::time_point start = Clock::now();
    set_alpha(viewer_.state().settings.request, angstrom2);
    const Alpha wanted = viewer_.state().settings.request.alpha_angstrom2;
    return until(start, [&] {
      const auto& result = viewer_.state().result;
      return result && result->request.alpha_angstrom2 == wanted;
    });
  }

  // Milliseconds until the picture with the moved ball is drawn. `ball` counts from 0; `step` is
  // along x, Å.
  double move_ball_by(std::size_t ball, double step) {
    const Clock::time_point start = Clock::now();
    const auto before = viewer_.state().result;
    Sandbox& sandbox = *viewer_.state().settings.open.sandbox;
    SandboxPlace place = centre_of(sandbox, ball);
    place[0] += step;
    move_ball(sandbox, ball, place);
    return until(start, [&] {
      const auto& result = viewer_.state().result;  // null until the new balls have a result
      return result && result != before;
    });
  }

  // Milliseconds of a frame in which nothing changes.
  double frame() {
    const Clock::time_point start = Clock::now();
    viewer_.step(&input_);
    viewer_.finish_frame();
    return milliseconds_since(start);
  }

  void wait_until_idle() {
    const Clock::time_point start = Clock::now();
    for (int quiet = 0; quiet < 4; quiet = viewer_.busy() ? 0 : quiet + 1) {
      if (viewer_.busy()) viewer_.host().wait_events(0.005);
      viewer_.step(&input_);
      require_in_time(start);
    }
  }

 private:
  template <class Shown>
  double until(Clock::time_point start, const Shown& shown) {
    viewer_.step(&input_);
    while (!shown()) {
      viewer_.wait_for_frame();
      viewer_.step(&input_);
      require_in_time(start);
    }
    viewer_.finish_frame();
    return milliseconds_since(start);
  }
  static void require_in_time(Clock::time_point start) {
    if (Clock::now() - start < kLongest) return;
    throw std::runtime_error("the requested picture was not drawn within five minutes");
  }

  Viewer& viewer_;
  ScriptedInput& input_;
};

// Median and maximum, for example "12.3 (15.1)".
std::string summary(std::vector<double> times) {
  if (times.empty()) return "none";
  std::sort(times.begin(), times.end());
  char text[64];
  std::snprintf(text, sizeof text, "%.2f (%.2f)", times[times.size() / 2], times.back());
  return text;
}

}  // namespace

std::string time_alpha_moves(Viewer& viewer, ScriptedInput& input, double angstrom2, int moves) {
  Mover mover(viewer, input);
  std::vector<double> whole, engine;
  std::map<std::string, std::vector<double>> stages;
  std::uint64_t hash = 0;
  const auto move = [&](int i) {
    mover.move_to(angstrom2 + (i % 2 == 0 ? kBeside : -kBeside));
    mover.wait_until_idle();
    return mover.move_to(angstrom2);
  };
  for (int i = 0; i < kWarmUp; ++i) {
    move(i);
    mover.wait_until_idle();
  }
  for (int i = 0; i < moves; ++i) {
    whole.push_back(move(i));
    const AlphaComplex& complex = viewer.state().result->complex;
    engine.push_back(complex.timings.wall_milliseconds);
    for (const StageTime& stage : viewer.picture_stages()) {
      stages[stage.label].push_back(stage.milliseconds);
    }
    if (i > 0 && complex.hash != hash)
      throw std::runtime_error("two moves to the same alpha gave different complexes");
    hash = complex.hash;
    mover.wait_until_idle();
  }
  char alpha[32];
  std::snprintf(alpha, sizeof alpha, "%g", angstrom2);
  std::string line = std::string("alpha ") + alpha + ": " + summary(whole) +
                     " ms to the picture, engine " + summary(engine);
  for (const auto label : {stage::kMesh, stage::kUpload, stage::kDraw}) {
    line += ", " + std::string(label) + " " + summary(stages[std::string(label)]);
  }
  return line + ", hash " + hash_text(hash);
}

std::string time_ball_moves(Viewer& viewer, ScriptedInput& input, int moves) {
  const auto& sandbox = viewer.state().settings.open.sandbox;
  if (!sandbox || sandbox->balls.empty()) throw std::runtime_error("there are no balls by hand");
  const std::size_t balls = sandbox->balls.size();
  Mover mover(viewer, input);
  std::vector<double> whole, engine, frame;
  mover.wait_until_idle();
  for (int i = 0; i < moves; ++i) {
    const double step = i / static_cast<int>(balls) % 2 == 0 ? kStep : -kStep;
    whole.push_back(mover.move_ball_by(static_cast<std::size_t>(i) % balls, step));
    engine.push_back(viewer.state().result->complex.timings.wall_milliseconds);
    mover.wait_until_idle();
    frame.push_back(mover.frame());
  }
  return "moves of " + std::to_string(balls) + " balls: " + summary(whole) +
         " ms to the picture, engine " + summary(engine) + ", a frame at rest " + summary(frame);
}

}  // namespace alphascope
