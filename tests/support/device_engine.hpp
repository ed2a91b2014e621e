// SPDX-License-Identifier: GPL-3.0-or-later
// The GPU engine without its replacement by the CPU.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "gpu/gpu_engine.hpp"
#include "gpu/gpu_library.hpp"

namespace alphascope::testing {

// The engine of the device that this program contains.
inline std::unique_ptr<Engine> make_gpu_engine(std::shared_ptr<const BallSet> balls,
                                               EngineOptions options, std::string* why_not,
                                               GpuOptions gpu_options = {}) {
  return alphascope::make_gpu_engine(gpu_library(), std::move(balls), std::move(options), why_not,
                                     gpu_options);
}

// A GPU engine that throws if its device fails. The program's GPU engine lets the CPU compute the
// same result, so comparisons would not notice a failure. Requests beyond the kernels' limits are
// still the CPU's.
class DeviceEngine : public Engine {
 public:
  explicit DeviceEngine(std::unique_ptr<Engine> engine) : engine_(std::move(engine)) {}

  AlphaComplex compute(const AlphaRequest& request, KnownResults& known,
                       const RunContext& context) override {
    AlphaComplex complex = engine_->compute(request, known, context);
    const std::string& route = complex.engine.route;
    if (route.find("on the CPU") != std::string::npos &&
        route.find("limits") == std::string::npos) {
      throw std::runtime_error("the device gave up: " + route);
    }
    return complex;
  }
  DeviceMeasuring measure(const AlphaComplex& complex, UnionMeasures& to,
                          const RunContext& context) override {
    DeviceMeasuring by = engine_->measure(complex, to, context);
    if (!by.why_not.empty() && by.why_not.find("limits") == std::string::npos) {
      throw std::runtime_error("the device gave up: " + by.why_not);
    }
    return by;
  }
  bool take(const std::shared_ptr<const BallSet>& balls) override { return engine_->take(balls); }
  void release_memory() override { engine_->release_memory(); }

 private:
  std::unique_ptr<Engine> engine_;
};

// Null, with the reason, where no device is usable.
inline std::unique_ptr<Engine> make_device_engine(std::shared_ptr<const BallSet> balls,
                                                  std::string* why_not = nullptr,
                                                  GpuOptions options = {}) {
  std::unique_ptr<Engine> engine = make_gpu_engine(std::move(balls), {}, why_not, options);
  return engine ? std::make_unique<DeviceEngine>(std::move(engine)) : nullptr;
}

}  // namespace alphascope::testing
