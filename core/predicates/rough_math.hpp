// SPDX-License-Identifier: GPL-3.0-or-later
// Fast reciprocals and square roots for bounds and filtered values, within 4 u (u = 2^-24, 2^-53)
// of the true value; also |x| and the larger of two numbers. Devices have an instruction for them;
// hosts divide. The last bits differ between machines, so a reported result may depend only on the
// bound.
#pragma once

#include <cmath>

#include "core/geometry/host_device.hpp"

namespace alphascope {

// Requires |x| in [2^-126, 2^126]. The instruction is within 1 ulp, and sqrt within 2^-23 relative
// (PTX ISA).
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

// Requires a normal number x > 0.
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

// Devices compute |x| at no cost and the larger of two numbers in one instruction. For `a > b ? a :
// b` a device compiler may not use that instruction, because NaN gives another result; a host's
// may. If one argument is NaN, larger() may return either.
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
