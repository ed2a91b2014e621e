// Replaces the measurer in builds without a CUDA compiler.
#include "gpu/gpu_engine.hpp"
#include "gpu/measure/gpu_measure.hpp"

namespace alphascope {

std::unique_ptr<GpuMeasurer> make_gpu_measurer(std::string* why_not) {
  if (why_not != nullptr) *why_not = gpu_device().why_not;
  return nullptr;
}

}  // namespace alphascope
