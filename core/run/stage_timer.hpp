// SPDX-License-Identifier: GPL-3.0-or-later
// Wall time of the named stages of a computation. Users see these labels.
#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

namespace alphascope {

// The stage table of all engines and executors (docs/algorithm.md).
namespace stage {
inline constexpr std::string_view kCoincident = "coincident centres";
inline constexpr std::string_view kGrid = "grid";
inline constexpr std::string_view kHostToDevice = "host→device";
inline constexpr std::string_view kCandidates = "kernel I (candidates)";
inline constexpr std::string_view kPrefixSum = "prefix sum";
inline constexpr std::string_view kFilteredValidity = "kernel II (filtered validity)";
// On the GPU kernels I and II are one launch: a block finds the neighbours of its balls and clips
// dual edges.
inline constexpr std::string_view kCandidatesAndFiltered =
    "kernels I+II (candidates, filtered validity)";
inline constexpr std::string_view kExactValidity = "kernel III (exact validity)";
inline constexpr std::string_view kDeviceToHost = "device→host";
// Time to reserve memory, and for runs that found too little of it.
inline constexpr std::string_view kMakingRoom = "making room";
inline constexpr std::string_view kTriangulation = "regular triangulation";
// A device's triangulation: the tetrahedra of a small K_alpha, all others, order and proof.
inline constexpr std::string_view kBulk = "tetrahedra of a small alpha";
inline constexpr std::string_view kOpenFaces = "open faces";
inline constexpr std::string_view kWrapping = "wrapping";
inline constexpr std::string_view kOrder = "order";
inline constexpr std::string_view kCertificate = "certificate";
inline constexpr std::string_view kHull = "hull";
inline constexpr std::string_view kClassification = "classification";
inline constexpr std::string_view kThreshold = "threshold";
inline constexpr std::string_view kHash = "hash and cache";
// Stages outside engines.
inline constexpr std::string_view kFlow = "flow of the triangulation";
inline constexpr std::string_view kCavities = "cavities";
inline constexpr std::string_view kExactVolumes = "exact volumes of cavities";
inline constexpr std::string_view kDefinition = "checking the definition";
}  // namespace stage

struct StageTime {
  std::string label;
  double milliseconds = 0;
  // Setup is done once per set of balls, all else for every alpha.
  bool setup = false;
};

struct StageTimes {
  std::vector<StageTime> stages;
  double wall_milliseconds = 0;  // of the whole computation, as its caller waited for it

  double setup_milliseconds() const {
    double sum = 0;
    for (const StageTime& s : stages) sum += s.setup ? s.milliseconds : 0;
    return sum;
  }
};

class StageTimer {
 public:
  explicit StageTimer(StageTimes& times) : times_(times), start_(Clock::now()), lap_(start_) {}

  // Ends the current stage under this label; the next one starts now.
  void lap(std::string_view label, bool setup = false) {
    const Clock::time_point now = Clock::now();
    times_.stages.push_back({std::string(label), milliseconds(lap_, now), setup});
    lap_ = now;
  }
  // Like lap(), for two interleaved stages: the second took `milliseconds_of_second` of the time.
  void lap_split(std::string_view first, std::string_view second, double milliseconds_of_second) {
    const Clock::time_point now = Clock::now();
    const double both = milliseconds(lap_, now);
    times_.stages.push_back({std::string(first), both - milliseconds_of_second, false});
    times_.stages.push_back({std::string(second), milliseconds_of_second, false});
    lap_ = now;
  }
  // Takes over the stages of a computation that was a part of this one.
  void adopt(const StageTimes& part) {
    times_.stages.insert(times_.stages.end(), part.stages.begin(), part.stages.end());
    lap_ = Clock::now();
  }
  // Starts the next stage now; the time since the last lap belongs to no stage.
  void restart_lap() { lap_ = Clock::now(); }
  // Sets the whole wall time, from construction to now.
  void finish() { times_.wall_milliseconds = milliseconds(start_, Clock::now()); }

 private:
  using Clock = std::chrono::steady_clock;
  static double milliseconds(Clock::time_point from, Clock::time_point to) {
    return std::chrono::duration<double, std::milli>(to - from).count();
  }
  StageTimes& times_;
  Clock::time_point start_, lap_;
};

}  // namespace alphascope
