// SPDX-License-Identifier: GPL-3.0-or-later
// Fills the table of the engines in this folder.
#include "gpu/gpu_library.hpp"

#include "gpu/gpu_engine.hpp"
#include "gpu/tuples/tuple_engine.hpp"
#include "gpu/wrapping/triangulator.hpp"

namespace alphascope {

const GpuLibrary& gpu_library() {
  static constexpr GpuLibrary table = {
      gpu_device,           make_gpu_executor,     make_gpu_tuple_engine, make_gpu_triangulator,
      is_gpu_memory_unused, free_unused_gpu_memory};
  return table;
}

}  // namespace alphascope
