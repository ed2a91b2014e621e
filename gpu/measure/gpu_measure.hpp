// Areas and volumes of unions of balls (core/measure/union_measures.hpp) on a CUDA device. Plain
// C++: the program builds and runs without CUDA.
#pragma once

#include <memory>
#include <string>

#include "core/measure/union_measures.hpp"

namespace alphascope {

// What a measurement on the device took, milliseconds; the first four by the device's clock.
struct GpuMeasureTimes {
  // Of the kernels: the balls, vertices, edges, triangles, tetrahedra and the result.
  double kernel[6] = {};
  double upload = 0, kernels = 0, download = 0, whole = 0;
};

// Keeps its device memory from one measurement to the next. For one thread at a time.
class GpuMeasurer {
 public:
  virtual ~GpuMeasurer() = default;
  // The same as measure_union() but for rounding, and the same bits each time on one device;
  // without derivatives. Fills `to`, whose arrays are used again. Throws what measure_union() does,
  // and std::runtime_error when the device fails, std::bad_alloc when its memory is full; the
  // measurer stays usable.
  virtual void measure(const BallSet& balls, const AlphaComplex& complex, UnionMeasures& to,
                       const RunContext& context = {}, GpuMeasureTimes* times = nullptr) = 0;
};

// Null when the device cannot be used (see gpu_device()): *why_not then says why.
std::unique_ptr<GpuMeasurer> make_gpu_measurer(std::string* why_not);

}  // namespace alphascope
