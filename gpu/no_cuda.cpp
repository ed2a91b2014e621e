// Replaces the CUDA engine in builds without a CUDA compiler.
#include "gpu/gpu_engine.hpp"

namespace alphascope {

const GpuDevice& gpu_device() {
  static const GpuDevice device = [] {
    GpuDevice d;
    d.why_not =
        "This build has no CUDA engine; install NVIDIA's CUDA compiler (nvcc) and run scripts/run "
        "again. The CPU engine gives the same results.";
    return d;
  }();
  return device;
}

bool is_gpu_memory_unused() {
  return false;
}
void free_unused_gpu_memory() {}

std::unique_ptr<Engine> make_gpu_engine(std::shared_ptr<const BallSet>, EngineOptions,
                                        std::string* why_not, GpuOptions) {
  if (why_not != nullptr) *why_not = gpu_device().why_not;
  return nullptr;
}

}  // namespace alphascope
