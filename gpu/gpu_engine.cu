// SPDX-License-Identifier: GPL-3.0-or-later
// Finds and tests the device, and runs the pipeline as an executor
// (core/engines/engine_of_executors.hpp).
#include "gpu/gpu_engine.hpp"

#include <optional>
#include <utility>

#include "core/engines/engine_of_executors.hpp"
#include "core/geometry/alpha.hpp"
#include "gpu/dual_edge/dual_edge_pipeline.hpp"
#include "gpu/measure/union_measurer.hpp"
#include "gpu/memory/device_buffer.cuh"
#include "gpu/memory/device_memory.hpp"
#include "gpu/memory/launch.cuh"
#include "gpu/memory/result_memory.cuh"
#include "gpu/outside/outside_finder.hpp"

namespace alphascope {
namespace {

__global__ void prove(int* out) {
  out[threadIdx.x] = static_cast<int>(threadIdx.x * threadIdx.x);
}

std::string version_text(int version) {
  return std::to_string(version / 1000) + "." + std::to_string(version % 1000 / 10);
}

// Launches a test kernel, because a driver that reports no fault can still fail at the first
// launch.
void run_probe() {
  gpu::DeviceBuffer<int> out;
  out.reserve(32);
  gpu::launch(prove, {1, 32, nullptr}, out.get());
  gpu::check(cudaGetLastError(), "starting a test kernel");
  int host[32] = {};
  gpu::check(cudaMemcpy(host, out.get(), sizeof host, cudaMemcpyDeviceToHost),
             "running a test kernel");
  for (int i = 0; i < 32; ++i) {
    if (host[i] != i * i) throw gpu::DeviceError("the GPU gave a wrong result in a test");
  }
}

GpuDevice probe_device() {
  GpuDevice d;
  constexpr const char* kFallback = " The CPU engine gives the same results.";
  int count = 0;
  const cudaError_t status = cudaGetDeviceCount(&count);
  int driver = 0;
  cudaDriverGetVersion(&driver);
  if (driver > 0) d.driver = "CUDA driver " + version_text(driver);
  if (status != cudaSuccess || count == 0) {
    cudaGetLastError();
    const std::string reason = status != cudaSuccess ? cudaGetErrorString(status) : "no device";
    if (status == cudaErrorInsufficientDriver && driver == 0) {
      d.why_not = std::string("No NVIDIA driver was found.") + kFallback;
    } else if (status == cudaErrorInsufficientDriver) {
      d.why_not = "The NVIDIA driver supports CUDA " + version_text(driver) +
                  ", this program needs " + version_text(CUDART_VERSION) + ": update the driver." +
                  kFallback;
    } else {
      d.why_not = "No usable NVIDIA GPU (" + reason + ")." + kFallback;
    }
    return d;
  }
  cudaDeviceProp properties{};
  if (cudaGetDeviceProperties(&properties, 0) == cudaSuccess) {
    d.name = properties.name;
    d.memory_bytes = properties.totalGlobalMem;
    d.compute_capability = properties.major * 10 + properties.minor;
  }
  if (const std::string wrong = gpu::DeviceMemory::read_limit(); !wrong.empty()) {
    d.why_not = wrong + "." + kFallback;
    return d;
  }
  try {
    run_probe();
    d.usable = true;
  } catch (const std::exception& error) {
    d.why_not = (d.name.empty() ? std::string("The GPU") : d.name) +
                " cannot be used: " + error.what() + "." + kFallback;
  }
  return d;
}

// Makes lists that refer to the pinned memory in which the result arrived.
template <int N>
void keep(const gpu::PipelineResult& result, const gpu::HostSimplices<N>& from,
          SimplexList<N>& to) {
  to.simplices = in_place(result.memory, from.simplices);
  to.alpha_values = in_place(result.memory, from.values);
  to.classes = in_place(result.memory, from.classes);
}

class GpuExecutor : public Executor {
 public:
  GpuExecutor(std::shared_ptr<const BallSet> balls, GpuOptions options)
      : balls_(std::move(balls)), pipeline_(*balls_, options.chunks) {}

  std::optional<AlphaComplex> compute(const AlphaRequest& request,
                                      const RunContext& context) override {
    AlphaComplex complex;
    complex.lattice = balls_->lattice;
    complex.alpha_on_lattice = balls_->lattice.alpha_on_lattice(request.alpha_angstrom2);
    complex.tetrahedra_only = request.tetrahedra_only;
    StageTimes whole;
    StageTimer wall(whole);
    const gpu::PipelineResult result = pipeline_.run(
        complex.alpha_on_lattice, request.tetrahedra_only, context.cancel, &complex.timings);
    if (!result.fits) return std::nullopt;
    keep(result, result.vertices, complex.vertices);
    keep(result, result.edges, complex.edges);
    keep(result, result.triangles, complex.triangles);
    keep(result, result.tetrahedra, complex.tetrahedra);
    complex.hash = last_hash_ = result.hash.combined(request.tetrahedra_only);
    wall.finish();
    complex.timings.wall_milliseconds = whole.wall_milliseconds;
    complex.engine = {"dual-edge engine", gpu_device().name, "dual edge clipping"};
    complex.engine.counters.push_back({"balls through kernel III", result.exact_balls});
    if (result.attempts > 1) {
      complex.engine.counters.push_back(
          {"runs, repeated for lack of memory", static_cast<std::uint64_t>(result.attempts)});
    }
    return complex;
  }

  DeviceMeasuring measure(const AlphaComplex& complex, UnionMeasures& to,
                          const RunContext& context) override {
    require_same_balls(*balls_, complex);
    try {
      if (!measurer_) measurer_.emplace();
      const std::optional<gpu::DeviceComplex> there = on_device(complex);
      const gpu::DeviceComplex measured =
          there ? *there : measurer_->upload(*balls_, complex, context.cancel);
      measurer_->measure(measured, context.cancel, nullptr).copy_to(to);
      return {gpu_device().name,
              there ? "the complex was still on the device" : "the complex was sent to the device",
              {}};
    } catch (const std::bad_alloc&) {
      measurer_.reset();
      throw;
    }
  }

  std::optional<SharedFaces> find_outer_faces(const AlphaComplex& complex) override {
    const std::optional<gpu::DeviceComplex> there = on_device(complex);
    if (!there) return std::nullopt;
    try {
      if (!outside_) outside_.emplace();
      return outside_->find(*there);
    } catch (const std::bad_alloc&) {
      outside_.reset();
      throw;
    }
  }

  bool take(const std::shared_ptr<const BallSet>& balls) override {
    pipeline_.load(*balls);
    balls_ = balls;
    return true;
  }

  // Frees also the memory for measures and the outside, because the next engine may need it.
  void release_memory() override {
    measurer_.reset();
    outside_.reset();
    pipeline_.release_memory();
  }

 private:
  // The last result on the device if it is `complex`: if alpha and hash are the same.
  std::optional<gpu::DeviceComplex> on_device(const AlphaComplex& complex) const {
    std::optional<gpu::DeviceComplex> there = pipeline_.on_device();
    const bool same =
        there && there->alpha_on_lattice == complex.alpha_on_lattice && last_hash_ == complex.hash;
    return same ? there : std::nullopt;
  }

  std::shared_ptr<const BallSet> balls_;
  gpu::DualEdgePipeline pipeline_;
  std::uint64_t last_hash_ = 0;  // hash of the pipeline's last result
  std::optional<gpu::UnionMeasurer> measurer_;
  std::optional<gpu::OuterFaceFinder> outside_;
};

}  // namespace

const GpuDevice& gpu_device() {
  static const GpuDevice device = probe_device();
  return device;
}

bool is_gpu_memory_unused() {
  return gpu::ResultMemory::is_any_unused();
}

void free_unused_gpu_memory() {
  gpu::ResultMemory::free_unused();
}

std::unique_ptr<Executor> make_gpu_executor(std::shared_ptr<const BallSet> balls,
                                            const GpuOptions& options) {
  return std::make_unique<GpuExecutor>(std::move(balls), options);
}

}  // namespace alphascope
