// SPDX-License-Identifier: GPL-3.0-or-later
// Chooses between device and CPU, and completes the report.
#include "core/triangulation/triangulation_maker.hpp"

#include <chrono>
#include <thread>
#include <utility>

#include "core/geometry/ball_set.hpp"
#include "core/triangulation/make_triangulation.hpp"

namespace alphascope {
namespace {

// With fewer balls the CPU takes some milliseconds only.
constexpr std::size_t kWorthBalls = 2000;

// Another thread may hold the device for a second. A cancel need not wait for it.
std::unique_lock<std::mutex> lock_unless_cancelled(std::mutex& mutex, const CancelToken& cancel) {
  constexpr std::chrono::milliseconds kPause{1};
  std::unique_lock lock(mutex, std::defer_lock);
  while (!lock.try_lock()) {
    cancel.throw_if_cancelled();
    std::this_thread::sleep_for(kPause);
  }
  return lock;
}

}  // namespace

DeviceTriangulation TriangulationMaker::make_on_device(const BallSet& balls,
                                                       const RunContext& context) {
  const std::unique_lock lock = lock_unless_cancelled(mutex_, context.cancel);
  DeviceTriangulation made;
  if (!find_device()) {
    made.report.why_not = no_device_;
    return made;
  }
  made = device_->make(balls, context);
  if (device_->takes_much_room()) release_kept();
  return made;
}

bool TriangulationMaker::find_device() {
  if (make_device_) device_ = std::exchange(make_device_, nullptr)(no_device_);
  holds_memory_ = holds_memory_ || device_ != nullptr;
  return device_ != nullptr;
}

template <class Made, class Make>
std::optional<Made> TriangulationMaker::make_of(const Triangulation& triangulation,
                                                const RunContext& context, const Make& make) {
  const bool failed = triangulation.report && !triangulation.report->why_not.empty();
  if (triangulation.dimension < 3 || triangulation.vertices.size() < kWorthBalls || failed)
    return std::nullopt;
  const std::unique_lock lock = lock_unless_cancelled(mutex_, context.cancel);
  if (!find_device()) return std::nullopt;
  std::optional<Made> made = make(*device_);
  if (device_->takes_much_room()) release_kept();
  return made;
}

std::optional<FiltrationParts> TriangulationMaker::filtration_parts(
    const BallSet& balls, const Triangulation& triangulation, const RunContext& context) {
  return make_of<FiltrationParts>(triangulation, context, [&](DeviceTriangulator& device) {
    std::string why_not;
    return device.filtration_parts(balls, triangulation, context, why_not);
  });
}

std::optional<TriangulationGround> TriangulationMaker::ground(const BallSet& balls,
                                                              const Triangulation& triangulation,
                                                              FlowTies ties,
                                                              const RunContext& context) {
  return make_of<TriangulationGround>(triangulation, context, [&](DeviceTriangulator& device) {
    std::string why_not;
    return device.ground(balls, triangulation, ties, context, why_not);
  });
}

std::optional<Membership> TriangulationMaker::membership(const Incidence& incidence,
                                                         const LatticeAlpha& alpha,
                                                         const CancelToken& cancel) {
  if (incidence.triangles.size() == 0) return std::nullopt;
  const std::unique_lock lock = lock_unless_cancelled(mutex_, cancel);
  return device_ ? device_->membership(incidence, alpha, cancel) : std::nullopt;
}

std::optional<ResultArray<OutsidePart>> TriangulationMaker::outside_parts(
    const Membership& in, std::span<const std::uint32_t> tetrahedra, double solvent,
    const CancelToken& cancel) {
  const std::unique_lock lock = lock_unless_cancelled(mutex_, cancel);
  return device_ ? device_->outside_parts(in, tetrahedra, solvent, cancel) : std::nullopt;
}

// One result is often made right after another. So the device counts as idle only if it is free
// some times in a row.
void TriangulationMaker::wait_until_idle(std::chrono::milliseconds most,
                                         const CancelToken& cancel) {
  constexpr std::chrono::microseconds kPause{100};
  constexpr int kEnough = 4;
  const auto end = std::chrono::steady_clock::now() + most;
  for (int free = 0; free < kEnough && std::chrono::steady_clock::now() < end;) {
    cancel.throw_if_cancelled();
    {
      const std::unique_lock lock(mutex_, std::try_to_lock);
      if (lock && !device_) return;
      free = lock ? free + 1 : 0;
    }
    std::this_thread::sleep_for(kPause);
  }
}

void TriangulationMaker::release_kept() {
  device_->release_memory();
  holds_memory_ = false;
}

bool TriangulationMaker::release_memory() {
  const std::lock_guard lock(mutex_);
  if (!holds_memory_) return false;
  release_kept();
  return true;
}

Triangulation TriangulationMaker::make(const BallSet& balls, int threads,
                                       const RunContext& context) {
  DeviceTriangulation made;
  if (balls.size() >= kWorthBalls) made = make_on_device(balls, context);
  Triangulation result;
  TriangulationReport report = std::move(made.report);
  if (made.triangulation) {
    result = *std::move(made.triangulation);
    report.by = TriangulationReport::By::device;
  } else {
    const std::string why_not = std::move(report.why_not);
    result = make_triangulation(balls, threads, context);
    report = *result.report;
    report.why_not = why_not;
  }
  result.report = std::make_shared<const TriangulationReport>(std::move(report));
  return result;
}

Triangulation make_triangulation_by(const std::shared_ptr<TriangulationMaker>& maker,
                                    const BallSet& balls, int threads, const RunContext& context) {
  return maker ? maker->make(balls, threads, context) : make_triangulation(balls, threads, context);
}

}  // namespace alphascope
