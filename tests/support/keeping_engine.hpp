// SPDX-License-Identifier: GPL-3.0-or-later
// An engine that keeps the results known of its balls, for tests with many requests.
#pragma once

#include <memory>
#include <utility>

#include "core/engine/engine.hpp"

namespace alphascope::testing {

class KeepingEngine : public Engine {
 public:
  explicit KeepingEngine(std::unique_ptr<Engine> engine) : engine_(std::move(engine)) {}

  // Uses the caller's known results, or else its own.
  AlphaComplex compute(const AlphaRequest& request, KnownResults& known,
                       const RunContext& context) override {
    if (known) return engine_->compute(request, known, context);
    const auto complex =
        std::make_shared<const AlphaComplex>(engine_->compute(request, known_, context));
    known_.share(complex);
    return *complex;
  }
  DeviceMeasuring measure(const AlphaComplex& complex, UnionMeasures& to,
                          const RunContext& context) override {
    return engine_->measure(complex, to, context);
  }
  std::optional<SharedFaces> find_outer_faces(const AlphaComplex& complex) override {
    return engine_->find_outer_faces(complex);
  }
  void release_memory() override { engine_->release_memory(); }

 private:
  std::unique_ptr<Engine> engine_;
  KnownResults known_;
};

inline std::unique_ptr<Engine> keeping(std::unique_ptr<Engine> engine) {
  return engine ? std::make_unique<KeepingEngine>(std::move(engine)) : nullptr;
}

}  // namespace alphascope::testing
