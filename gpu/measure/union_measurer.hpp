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
