// Runs the kernels of core/measure for one complex after the other. Plain C++; the face is
// gpu_measure.hpp.
#pragma once

#include <memory>
#include <span>

#include "core/complex/alpha_complex.hpp"
#include "core/run/cancel_token.hpp"
#include "gpu/measure/gpu_measure.hpp"
#include "gpu/memory/device_complex.hpp"

namespace alphascope::gpu {

// As UnionMeasures; arrays in pinned memory.
struct HostMeasures {
  double area_angstrom2 = 0, volume_angstrom3 = 0;
  std::span<const double> ball_area_angstrom2, ball_volume_angstrom3;

  void copy_to(UnionMeasures& to) const {
    to.area_angstrom2 = area_angstrom2;
    to.volume_angstrom3 = volume_angstrom3;
    to.ball_area_angstrom2.assign(ball_area_angstrom2.begin(), ball_area_angstrom2.end());
    to.ball_volume_angstrom3.assign(ball_volume_angstrom3.begin(), ball_volume_angstrom3.end());
  }
};

class UnionMeasurer {
 public:
  UnionMeasurer();  // throws DeviceError
  ~UnionMeasurer();

  // Both throw Cancelled, std::bad_alloc, DeviceError.
  // Copies a complex to the device, where it stays until the next one.
  DeviceComplex upload(const BallSet& balls, const AlphaComplex& complex,
                       const CancelToken& cancel);
  // Valid until the next one. `times`: of the last upload, too.
  HostMeasures measure(const DeviceComplex& complex, const CancelToken& cancel,
                       GpuMeasureTimes* times);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace alphascope::gpu
