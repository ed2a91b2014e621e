// SPDX-License-Identifier: GPL-3.0-or-later
// The symbols of the library alphascope-gpu.so. It exports nothing else.
#include "core/run/library_build.hpp"
#include "gpu/gpu_library.hpp"

extern "C" {

__attribute__((visibility("default"))) const char* alphascope_gpu_build() {
  return alphascope::library_build();
}

__attribute__((visibility("default"))) const alphascope::GpuLibrary* alphascope_gpu_library() {
  return &alphascope::gpu_library();
}
}
