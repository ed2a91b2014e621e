// Quick reciprocals and square roots for bounds and filtered values, within 4 u (u = 2^-24, 2^-53)
// of the true value. Devices have an instruction for them; hosts divide. Results differ between
// machines in the last bits, so nothing that is reported may depend on more than the bound. And
// magnitudes.
#pragma once

#include <cmath>

#include "core/geometry/host_device.hpp"

namespace alphascope {

// |x| in [2^-126, 2^126]. The instruction is within 1 ulp, sqrt within 2^-23 relative (PTX ISA).
ALPHASCOPE_INLINE float rough_reciprocal(float x) {
#ifdef __CUDA_ARCH__
  float y;
  asm("rcp.approx.ftz.f32 %0, %1;" : "=f"(y) : "f"(x));
  return y;
#else
  return 1.0f / x;
#endif
}
ALPHASCOPE_INLINE double rough_reciprocal(double x) {
  return 1.0 / x;
}

// x > 0, a normal number.
ALPHASCOPE_INLINE float rough_square_root(float x) {
#ifdef __CUDA_ARCH__
  float y;
  asm("sqrt.approx.ftz.f32 %0, %1;" : "=f"(y) : "f"(x));
  return y;
#else
  return std::sqrt(x);
#endif
}
ALPHASCOPE_INLINE double rough_square_root(double x) {
  return sqrt(x);
}

// Devices have |x| for nothing and the larger of two in one instruction, but a compiler may use
// neither for a comparison and a choice, because of what is not a number. Hosts may. Of a number
// and what is none, either may be the larger.
ALPHASCOPE_INLINE float magnitude(float x) {
  return fabsf(x);
}
ALPHASCOPE_INLINE double magnitude(double x) {
  return fabs(x);
}
ALPHASCOPE_INLINE float larger(float a, float b) {
#ifdef __CUDA_ARCH__
  return fmaxf(a, b);
#else
  return a > b ? a : b;
#endif
}
ALPHASCOPE_INLINE double larger(double a, double b) {
  return a > b ? a : b;
}

}  // namespace alphascope
