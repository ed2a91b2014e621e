// SPDX-License-Identifier: GPL-3.0-or-later
// The GPU engines of the program. They are in a library of their own
// (core/engines/gpu_library.hpp), so a program starts without CUDA and works without the library.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/engine/engine.hpp"
#include "core/engine/gpu_device.hpp"
#include "core/engines/gpu_library.hpp"
#include "core/triangulation/triangulation_maker.hpp"
#include "core/tuples/tuple_options.hpp"

namespace alphascope {

// Any thread may call all functions. None throws, except where memory is short.
class GpuEngines {
 public:
  // Those of the running program. The first call loads the library, which takes milliseconds.
  static const GpuEngines& of_program();

  // Loads the first of these files that exists. If it cannot be used, later ones are not tried.
  explicit GpuEngines(const std::vector<std::filesystem::path>& places);

  // If there is no usable library, GpuDevice::why_not gives the reason. The first call may take a
  // second.
  const GpuDevice& device() const;
  // Both return null if the GPU cannot be used, and set `why_not` to the reason.
  std::unique_ptr<Engine> make_engine(std::shared_ptr<const BallSet> balls,
                                      const EngineOptions& options, std::string& why_not) const;
  std::unique_ptr<Engine> make_tuple_engine(std::shared_ptr<const BallSet> balls,
                                            const TupleOptions& tuples, std::string& why_not) const;
  // Makes triangulations on the GPU, or on the CPU where it cannot be used. Engines and derived
  // results share it, and with it the memory on the GPU.
  const std::shared_ptr<TriangulationMaker>& triangulations() const { return triangulations_; }
  // As in GpuLibrary.
  bool is_memory_unused() const { return library_ != nullptr && library_->is_memory_unused(); }
  void free_unused_memory() const {
    if (library_ != nullptr) library_->free_unused_memory();
  }

 private:
  const GpuLibrary* library_ = nullptr;  // never unloaded
  GpuDevice none_;                       // says why there is no library
  std::shared_ptr<TriangulationMaker> triangulations_;
};

// Returns absolute paths at which the library of an executable may be. The environment variable
// ALPHASCOPE_GPU_LIBRARY replaces them all by one path; if it is empty, there is none. Otherwise it
// belongs to the installation of which `program` is a part; a build folder has the same layout.
std::vector<std::filesystem::path> gpu_library_places(const std::filesystem::path& program);

}  // namespace alphascope
