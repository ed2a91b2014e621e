// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the tuple engine on a CUDA device.
#include "gpu/tuples/tuple_engine.hpp"

#include "core/tuples/tuple_compute.hpp"
#include "gpu/gpu_engine.hpp"
#include "gpu/tuples/tuple_executor.cuh"

namespace alphascope {
namespace {

template <class Reader>
class GpuTupleEngine : public Engine {
 public:
  GpuTupleEngine(std::shared_ptr<const BallSet> balls, TupleOptions tuples)
      : executor_(tuples), computer_(std::move(balls), tuples, executor_) {}

  AlphaComplex compute(const AlphaRequest& request, KnownResults&,
                       const RunContext& context) override {
    AlphaComplex complex = computer_.compute(request, context);
    complex.engine.name = "tuple engine";
    complex.engine.device = gpu_device().name;
    return complex;
  }

 private:
  gpu::CudaTupleExecutor<Reader> executor_;
  TupleComputer<gpu::CudaTupleExecutor<Reader>> computer_;
};

}  // namespace

std::unique_ptr<Engine> make_gpu_tuple_engine(std::shared_ptr<const BallSet> balls,
                                              TupleOptions tuples, std::string* why_not) {
  const GpuDevice& device = gpu_device();
  std::string reason = device.why_not;
  if (device.usable) {
    try {
      if (tuples.texture) {
        return std::make_unique<GpuTupleEngine<gpu::TextureReader>>(std::move(balls), tuples);
      }
      return std::make_unique<GpuTupleEngine<PlainReader>>(std::move(balls), tuples);
    } catch (const std::exception& error) {
      reason = device.name + " cannot be used: " + error.what();
    }
  }
  if (why_not != nullptr) *why_not = reason;
  return nullptr;
}

}  // namespace alphascope
