// SPDX-License-Identifier: GPL-3.0-or-later
// Loads the library with the GPU engines, and passes requests on to it.
#include "app/session/gpu_engines.hpp"

#include <exception>
#include <utility>

#include "app/session/loaded_library.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/wrapping/seed.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFallback = " The CPU engine gives the same results.";

constexpr LibraryKind kGpu{
    .file_name = "alphascope-gpu.so",
    .variable = "ALPHASCOPE_GPU_LIBRARY",
    .title = "GPU library",
    .build_symbol = "alphascope_gpu_build",
    .table_symbol = "alphascope_gpu_library",
    .if_missing =
        "Install the package alphascope-cuda; or, with the sources, NVIDIA's CUDA compiler (nvcc), "
        "and run scripts/run again."};

// The library is never unloaded, because results refer to it.
const GpuLibrary& load_first(const std::vector<fs::path>& places) {
  return *reinterpret_cast<decltype(&alphascope_gpu_library)>(load_library(kGpu, places))();
}

// Returns null if the GPU cannot be used. Sets `why_not` to the reason if there is a GPU.
std::unique_ptr<DeviceTriangulator> triangulator_of(const GpuLibrary* library,
                                                    std::string& why_not) {
  if (library == nullptr || !library->device().usable) return nullptr;
  try {
    return library->make_triangulator(seed_tetrahedron);
  } catch (const std::exception& error) {
    why_not = error.what();
    return nullptr;
  }
}

}  // namespace

const GpuEngines& GpuEngines::of_program() {
  static const GpuEngines engines(library_places(kGpu));
  return engines;
}

GpuEngines::GpuEngines(const std::vector<fs::path>& places) {
  try {
    library_ = &load_first(places);
  } catch (const UnusableLibrary& error) {
    none_.why_not = error.what() + std::string(kFallback);
  }
  triangulations_ = std::make_shared<TriangulationMaker>(
      [library = library_](std::string& why_not) { return triangulator_of(library, why_not); });
}

const GpuDevice& GpuEngines::device() const {
  return library_ != nullptr ? library_->device() : none_;
}

std::unique_ptr<Engine> GpuEngines::make_engine(std::shared_ptr<const BallSet> balls,
                                                const EngineOptions& options,
                                                std::string& why_not) const {
  if (library_ == nullptr) {
    why_not = none_.why_not;
    return nullptr;
  }
  EngineOptions with_device = options;
  with_device.triangulations = triangulations_;
  return make_gpu_engine(*library_, std::move(balls), with_device, &why_not);
}

std::unique_ptr<Engine> GpuEngines::make_tuple_engine(std::shared_ptr<const BallSet> balls,
                                                      const TupleOptions& tuples,
                                                      std::string& why_not) const {
  if (library_ != nullptr) return library_->make_tuple_engine(std::move(balls), tuples, &why_not);
  why_not = none_.why_not;
  return nullptr;
}

std::vector<fs::path> gpu_library_places(const fs::path& program) {
  return library_places(kGpu, program);
}

}  // namespace alphascope
