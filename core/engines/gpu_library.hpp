// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary between the programs and the library with the GPU engines: one table of functions.
// The library, alphascope-gpu.so, has kernels and the parts of core that their callers use. It is
// loaded when a program first asks for a GPU (app/session/gpu_engines.hpp).
//
// The library needs nothing of the program. It gives executors, which say when a request is beyond
// them. The program makes engines of these, so slabs and the CPU engine are the program's own.
//
// Types of the standard library and exceptions cross the boundary. Both sides must therefore be
// made of the same sources by the same compiler. library_build() names both, and a library with
// another name is refused before anything else is called. The library is never unloaded, because
// results refer to its memory and its functions. Exceptions are caught by type on the other side:
// the runtime of GCC and clang compares types by name, so symbols need not be shared.
#pragma once

#include <memory>
#include <string>

#include "core/engine/gpu_device.hpp"
#include "core/engines/engine_of_executors.hpp"
#include "core/triangulation/device_triangulator.hpp"
#include "core/tuples/tuple_options.hpp"

namespace alphascope {

// Options of the device's engine. Results do not depend on them.
struct GpuOptions {
  // Number of chunks of balls in a run, 1 to 16; 0: the fastest.
  int chunks = 0;
};

// All functions may be called from any thread.
struct GpuLibrary {
  // Looks for a device and runs a small kernel on it. The answer is kept. Never throws.
  const GpuDevice& (*device)();
  // For a usable device only. Throws as Executor::compute() does.
  std::unique_ptr<Executor> (*make_executor)(std::shared_ptr<const BallSet> balls,
                                             const GpuOptions& options);
  // Returns null if the device cannot be used, and sets *why_not to the reason.
  std::unique_ptr<Engine> (*make_tuple_engine)(std::shared_ptr<const BallSet> balls,
                                               TupleOptions tuples, std::string* why_not);
  // For a usable device only. Throws std::bad_alloc and ExecutorFailed.
  std::unique_ptr<DeviceTriangulator> (*make_triangulator)(FindSeed find_seed);
  // Returns whether there is pinned memory of results that are no longer used. Fast.
  bool (*is_memory_unused)();
  // Frees that memory. Waits for the device, so it must not be called by the thread that draws.
  void (*free_unused_memory)();
};

// Makes the engine of the device. Requests that do not fit the device are cut into slabs, and at
// last computed by the CPU engine. Their AlphaComplex says so in engine.route. Returns null if the
// device cannot be used, and sets *why_not to the reason.
std::unique_ptr<Engine> make_gpu_engine(const GpuLibrary& library,
                                        std::shared_ptr<const BallSet> balls, EngineOptions options,
                                        std::string* why_not, GpuOptions gpu_options = {});

}  // namespace alphascope

// The symbols that the library exports. alphascope_gpu_build() must be called first, and the other
// one only if it returns the program's own library_build() (core/run/library_build.hpp).
extern "C" {
const char* alphascope_gpu_build();
const alphascope::GpuLibrary* alphascope_gpu_library();
}
