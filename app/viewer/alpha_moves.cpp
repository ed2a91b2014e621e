// See the header.
#include "app/viewer/alpha_moves.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>
#include <stdexcept>
#include <vector>

#include "app/viewer/viewer.hpp"
#include "core/run/picture_stages.hpp"
#include "ui/panels/controls.hpp"

namespace alphascope {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kLongest{300};
constexpr double kBeside = 0.05;  // Å², from where alpha moves: another complex, about as large

class AlphaMover {
 public:
  AlphaMover(Viewer& viewer, ScriptedInput& input) : viewer_(viewer), input_(input) {}

  // Milliseconds until the picture of this alpha is drawn.
  double move_to(double angstrom2) {
    const Clock::time_point start = Clock::now();
    set_alpha(viewer_.state().compute, angstrom2);
    const double wanted = viewer_.state().compute.alpha_angstrom2;
    const auto shown = [&] {
      const auto& result = viewer_.state().result;
      return result && result->request.alpha_angstrom2 == wanted;
    };
    viewer_.step(&input_);
    while (!shown()) {
      viewer_.wait_for_frame();
      viewer_.step(&input_);
      require_in_time(start);
    }
    viewer_.finish_frame();
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  }

  void rest() {
    const Clock::time_point start = Clock::now();
    for (int quiet = 0; quiet < 4; quiet = viewer_.busy() ? 0 : quiet + 1) {
      if (viewer_.busy()) viewer_.host().wait_events(0.005);
      viewer_.step(&input_);
      require_in_time(start);
    }
  }

 private:
  static void require_in_time(Clock::time_point start) {
    if (Clock::now() - start < kLongest) return;
    throw std::runtime_error("no picture of the new alpha after five minutes");
  }

  Viewer& viewer_;
  ScriptedInput& input_;
};

// "12.3 (15.1)": median and longest.
std::string summary(std::vector<double> times) {
  if (times.empty()) return "none";
  std::sort(times.begin(), times.end());
  char text[64];
  std::snprintf(text, sizeof text, "%.2f (%.2f)", times[times.size() / 2], times.back());
  return text;
}

}  // namespace

std::string time_alpha_moves(Viewer& viewer, ScriptedInput& input, double angstrom2, int moves) {
  AlphaMover mover(viewer, input);
  std::vector<double> whole, engine;
  std::map<std::string, std::vector<double>> stages;
  std::uint64_t hash = 0;
  for (int i = 0; i < moves; ++i) {
    mover.move_to(angstrom2 + (i % 2 == 0 ? kBeside : -kBeside));
    mover.rest();
    whole.push_back(mover.move_to(angstrom2));
    const AlphaComplex& complex = viewer.state().result->complex;
    engine.push_back(complex.timings.wall_milliseconds);
    for (const StageTime& stage : viewer.picture_stages()) {
      stages[stage.label].push_back(stage.milliseconds);
    }
    if (i > 0 && complex.hash != hash) throw std::runtime_error("two complexes for one alpha");
    hash = complex.hash;
    mover.rest();
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

}  // namespace alphascope
