// SPDX-License-Identifier: GPL-3.0-or-later
// Areas and volumes of unions of balls (core/measure/union_measures.hpp) on a CUDA device. This
// header is plain C++.
#pragma once

#include <memory>
#include <string>

#include "core/measure/union_measures.hpp"

namespace alphascope {

// Times of a measurement on the device, milliseconds. The first four are by the device's clock.
struct GpuMeasureTimes {
  // Times of the kernels for balls, vertices, edges, triangles, tetrahedra and the result.
  double kernel[6] = {};
  double upload = 0, kernels = 0, download = 0, whole = 0;
};

// Keeps its device memory from one measurement to the next. May be used by one thread at a time.
class GpuMeasurer {
 public:
  virtual ~GpuMeasurer() = default;
  // Fills `to`, whose arrays are reused, with the result of measure_union() except for rounding,
  // without derivatives. One device gives the same bits each time. Throws as measure_union(). Also
  // throws std::runtime_error if the device fails, and std::bad_alloc if its memory is full. The
  // measurer stays usable.
  virtual void measure(const BallSet& balls, const AlphaComplex& complex, UnionMeasures& to,
                       const RunContext& context = {}, GpuMeasureTimes* times = nullptr) = 0;
};

// Returns null if the device cannot be used (see gpu_device()), and sets *why_not to the reason.
std::unique_ptr<GpuMeasurer> make_gpu_measurer(std::string* why_not);

}  // namespace alphascope
