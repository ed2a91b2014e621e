// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the kernels of core/measure for one complex after the other. This header is plain C++;
// gpu_measure.hpp is the public interface.
#pragma once

#include <memory>
#include <span>

#include "core/complex/alpha_complex.hpp"
#include "core/run/cancel_token.hpp"
#include "gpu/measure/gpu_measure.hpp"
#include "gpu/memory/device_complex.hpp"

namespace alphascope::gpu {

// As UnionMeasures, with arrays in pinned memory.
struct HostMeasures {
  PerQuantity<double> total = {};
  PerQuantity<std::span<const double>> of_ball;

  void copy_to(UnionMeasures& to) const {
    to.total = total;
    each_quantity(
        [&](MeasuredQuantity q) { to.of_ball[q].assign(of_ball[q].begin(), of_ball[q].end()); });
  }
};

class UnionMeasurer {
 public:
  UnionMeasurer();  // throws DeviceError
  ~UnionMeasurer();

  // Both functions throw Cancelled, std::bad_alloc and DeviceError. The first copies a complex to
  // the device, where it stays until the next one.
  DeviceComplex upload(const BallSet& balls, const AlphaComplex& complex,
                       const CancelToken& cancel);
  // The result is valid until the next measurement. `times` includes the last upload.
  HostMeasures measure(const DeviceComplex& complex, const CancelToken& cancel,
                       GpuMeasureTimes* times);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace alphascope::gpu
