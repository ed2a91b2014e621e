// SPDX-License-Identifier: GPL-3.0-or-later
// An engine for tests of the session. Its complex is one vertex for each ball. It waits and fails
// on demand, and counts requests. It computes no geometry.
#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/session/engines.hpp"
#include "core/measure/union_measures.hpp"

namespace alphascope::test {

struct FakeEngineLog {
  std::atomic<int> rested{0};
  std::atomic<int> made{0}, started{0}, finished{0}, cancelled{0};
  std::atomic<bool> hold{false};          // computations wait, and notice their cancel token
  std::atomic<bool> fail_next{false};     // the next computation throws
  std::atomic<bool> set_up_again{false};  // later answers have set-up stages, too
  std::atomic<int> steps{1};              // of 50 µs each
  std::atomic<int> measured{0};
  std::atomic<bool> takes{false};          // takes other balls
  std::atomic<bool> finds_outside{false};  // finds no face, in a millisecond
  DeviceMeasuring measuring;  // answers measure(); by a device with an area of 123 Å²
};

class FakeEngine : public Engine {
 public:
  FakeEngine(std::shared_ptr<const BallSet> balls, FakeEngineLog& log)
      : balls_(std::move(balls)), log_(log) {}

  AlphaComplex compute(const AlphaRequest& request, KnownResults&,
                       const RunContext& context) override {
    ++log_.started;
    context.report(stage::kGrid, 0.5);
    for (int step = 0; step < log_.steps || log_.hold; ++step) {
      if (context.cancel.cancelled()) {
        ++log_.cancelled;
        throw Cancelled();
      }
      std::this_thread::sleep_for(std::chrono::microseconds(50));
    }
    if (log_.fail_next.exchange(false)) throw std::runtime_error("broken on purpose");
    AlphaComplex complex;
    complex.lattice = balls_->lattice;
    complex.alpha_on_lattice = balls_->lattice.alpha_on_lattice(request.alpha_angstrom2);
    complex.tetrahedra_only = request.tetrahedra_only;
    for (BallIndex i = 0; i < balls_->size(); ++i) {
      complex.vertices.simplices.push_back({i});
      complex.vertices.alpha_values.push_back(static_cast<float>(-balls_->weight(i)));
      complex.vertices.classes.push_back(SimplexClass::singular);
    }
    complex.timings.stages.push_back({"fake", 1.0, first_ || log_.set_up_again});
    first_ = false;
    ++log_.finished;
    return complex;
  }
  bool take(const std::shared_ptr<const BallSet>& balls) override {
    if (log_.takes) balls_ = balls;
    return log_.takes;
  }
  DeviceMeasuring measure(const AlphaComplex&, UnionMeasures& to, const RunContext&) override {
    ++log_.measured;
    if (log_.measuring.device.empty()) return log_.measuring;
    to.total[MeasuredQuantity::area] = 123;
    return log_.measuring;
  }
  std::optional<SharedFaces> find_outer_faces(const AlphaComplex&) override {
    if (!log_.finds_outside) return std::nullopt;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return SharedFaces{};
  }
  void release_memory() override { ++log_.rested; }

 private:
  std::shared_ptr<const BallSet> balls_;
  FakeEngineLog& log_;
  bool first_ = true;
};

// The log must outlive the engines.
inline EngineFactory fake_factory(FakeEngineLog& log) {
  return [&log](EngineChoice, std::shared_ptr<const BallSet> balls, const EngineSettings&) {
    ++log.made;
    MadeEngine made;
    made.engine = std::make_unique<FakeEngine>(std::move(balls), log);
    return made;
  };
}

inline std::shared_ptr<const BallSet> few_balls(int count) {
  auto balls = std::make_shared<BallSet>();
  for (int i = 0; i < count; ++i) {
    balls->centres.push_back({i * 1000, (i % 3) * 700, (i % 5) * 300});
    balls->radii.push_back(1700);
  }
  return balls;
}

}  // namespace alphascope::test
