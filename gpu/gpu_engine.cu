// The CUDA engine's face: finds and proves the device, runs the pipeline, falls back to the CPU.
#include "gpu/gpu_engine.hpp"

#include <cmath>
#include <optional>
#include <stdexcept>

#include "core/engine/slabs.hpp"
#include "gpu/dual_edge/dual_edge_pipeline.hpp"
#include "gpu/memory/device_buffer.cuh"
#include "gpu/memory/launch.cuh"
#include "gpu/memory/result_memory.cuh"

namespace alphascope {
namespace {

__global__ void prove(int* out) {
  out[threadIdx.x] = static_cast<int>(threadIdx.x * threadIdx.x);
}

std::string version_text(int version) {
  return std::to_string(version / 1000) + "." + std::to_string(version % 1000 / 10);
}

// A healthy-looking driver can still fail at the first launch, so one is made.
void run_probe() {
  gpu::DeviceBuffer<int> out;
  out.reserve(32);
  gpu::launch(prove, {1, 32, nullptr}, out.get());
  gpu::check(cudaGetLastError(), "starting a test kernel");
  int host[32] = {};
  gpu::check(cudaMemcpy(host, out.get(), sizeof host, cudaMemcpyDeviceToHost),
             "running a test kernel");
  for (int i = 0; i < 32; ++i) {
    if (host[i] != i * i)
      throw gpu::DeviceError("the GPU computed a wrong number in a test kernel");
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
  try {
    run_probe();
    d.usable = true;
  } catch (const std::exception& error) {
    d.why_not = (d.name.empty() ? std::string("The GPU") : d.name) +
                " cannot be used: " + error.what() + "." + kFallback;
  }
  return d;
}

// A result stays in the pinned memory that it arrived in.
template <int N>
void keep(const gpu::PipelineResult& result, const gpu::HostSimplices<N>& from,
          SimplexList<N>& to) {
  to.simplices = in_place(result.memory, from.simplices);
  to.alpha_values = in_place(result.memory, from.values);
  to.classes = in_place(result.memory, from.classes);
}

// More slabs than this and the halos are most of the work.
constexpr std::size_t kMostSlabs = 256;

class GpuEngine : public Engine {
 public:
  GpuEngine(std::shared_ptr<const BallSet> balls, EngineOptions options, GpuOptions gpu_options)
      : balls_(std::move(balls)), options_(options), gpu_options_(gpu_options) {}

  AlphaComplex compute(const AlphaRequest& request, const RunContext& context) override {
    if (std::isnan(request.alpha_angstrom2)) throw std::invalid_argument("alpha is not a number");
    std::string why_cpu = "beyond the GPU kernels' limits";
    try {
      if (std::optional<AlphaComplex> complex = on_device(request, context))
        return *std::move(complex);
    } catch (const gpu::DeviceError& error) {
      pipeline_.reset();  // whatever it still holds is of no use
      why_cpu = error.what();
    } catch (const std::bad_alloc&) {
      why_cpu = "the GPU's memory is full";
    }
    rest();
    if (!cpu_) cpu_ = make_cpu_engine(balls_, options_);
    AlphaComplex complex = cpu_->compute(request, context);
    complex.engine.route += " (on the CPU: " + why_cpu + ")";
    return complex;
  }

  void rest() override {
    if (pipeline_) pipeline_->rest();
  }

 private:
  // The set at once, or in as few slabs as the device's memory allows. Nothing when the request is
  // beyond the kernels' limits.
  std::optional<AlphaComplex> on_device(const AlphaRequest& request, const RunContext& context) {
    if (may_need_fewer_slabs(request)) slabs_ /= 2;
    for (;;) {
      try {
        std::optional<AlphaComplex> complex =
            slabs_ == 1 ? whole_set(request, context) : in_slabs(request, context);
        ++answers_in_slabs_;
        return complex;
      } catch (const std::bad_alloc&) {
        pipeline_.reset();
        if (slabs_ >= kMostSlabs || slabs_ > balls_->size()) throw;
        slabs_ *= 2;
        refused_ = {request.alpha_angstrom2, request.tetrahedra_only};  // not what was lent
        answers_in_slabs_ = 0;
      }
    }
  }

  // A request that is smaller than the one that half as many slabs had no room for; or any, once in
  // a while, since others may have had the device's memory.
  bool may_need_fewer_slabs(const AlphaRequest& request) const {
    constexpr int kAnswersBeforeTrial = 8;
    if (slabs_ == 1) return false;
    return request.alpha_angstrom2 < refused_.alpha_angstrom2 ||
           (request.tetrahedra_only && !refused_.tetrahedra_only) ||
           answers_in_slabs_ >= kAnswersBeforeTrial;
  }

  std::optional<AlphaComplex> whole_set(const AlphaRequest& request, const RunContext& context) {
    if (!pipeline_)
      pipeline_ = std::make_unique<gpu::DualEdgePipeline>(*balls_, gpu_options_.chunks);
    return run(*pipeline_, *balls_, request, context);
  }

  std::optional<AlphaComplex> in_slabs(const AlphaRequest& request, const RunContext& context) {
    struct BeyondLimits {};
    try {
      AlphaComplex complex = compute_in_slabs(
          *balls_, request, slabs_, context, [&](std::shared_ptr<const BallSet> part) {
            gpu::DualEdgePipeline pipeline(*part, gpu_options_.chunks);
            std::optional<AlphaComplex> result = run(pipeline, *part, request, context);
            if (!result) throw BeyondLimits{};
            return *std::move(result);
          });
      complex.engine.route += ", in " + std::to_string(slabs_) + " slabs";
      return complex;
    } catch (const BeyondLimits&) {
      return std::nullopt;
    }
  }

  std::optional<AlphaComplex> run(gpu::DualEdgePipeline& pipeline, const BallSet& balls,
                                  const AlphaRequest& request, const RunContext& context) {
    AlphaComplex complex;
    complex.lattice = balls.lattice;
    complex.alpha_on_lattice = balls.lattice.alpha_on_lattice(request.alpha_angstrom2);
    complex.tetrahedra_only = request.tetrahedra_only;
    StageTimes whole;
    StageTimer wall(whole);
    const gpu::PipelineResult result = pipeline.run(
        complex.alpha_on_lattice, request.tetrahedra_only, context.cancel, &complex.timings);
    if (!result.fits) return std::nullopt;
    keep(result, result.vertices, complex.vertices);
    keep(result, result.edges, complex.edges);
    keep(result, result.triangles, complex.triangles);
    keep(result, result.tetrahedra, complex.tetrahedra);
    complex.hash = result.hash.combined(request.tetrahedra_only);
    wall.finish();
    complex.timings.wall_milliseconds = whole.wall_milliseconds;
    complex.engine = {"dual-edge engine", gpu_device().name, "dual edge clipping"};
    complex.engine.counters.push_back({"balls through kernel III", result.exact_balls});
    if (result.attempts > 1) {
      complex.engine.counters.push_back(
          {"runs for want of room", static_cast<std::uint64_t>(result.attempts)});
    }
    return complex;
  }

  std::shared_ptr<const BallSet> balls_;
  EngineOptions options_;
  GpuOptions gpu_options_;
  std::size_t slabs_ = 1;
  AlphaRequest refused_;      // the last that half as many slabs had no room for
  int answers_in_slabs_ = 0;  // since then
  std::unique_ptr<gpu::DualEdgePipeline> pipeline_;
  std::unique_ptr<Engine> cpu_;
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

std::unique_ptr<Engine> make_gpu_engine(std::shared_ptr<const BallSet> balls, EngineOptions options,
                                        std::string* why_not, GpuOptions gpu_options) {
  const GpuDevice& device = gpu_device();
  std::string reason = device.why_not;
  if (device.usable) {
    try {
      return std::make_unique<GpuEngine>(std::move(balls), options, gpu_options);
    } catch (const std::exception& error) {
      reason = device.name + " cannot take this molecule: " + error.what() +
               ". The CPU engine gives the same results.";
    }
  }
  if (why_not != nullptr) *why_not = reason;
  return nullptr;
}

}  // namespace alphascope
