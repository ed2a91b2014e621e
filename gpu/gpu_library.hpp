// SPDX-License-Identifier: GPL-3.0-or-later
// The table of the engines in this folder. Programs get it from the library alphascope-gpu.so.
// Tests and benchmarks contain the engines, and call this function.
#pragma once

#include "core/engines/gpu_library.hpp"

namespace alphascope {

const GpuLibrary& gpu_library();

}  // namespace alphascope
