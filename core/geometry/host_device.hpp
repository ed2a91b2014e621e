// SPDX-License-Identifier: GPL-3.0-or-later
// Marks functions that both the CPU executor and the CUDA executor compile.
#pragma once

#ifdef __CUDACC__
#define ALPHASCOPE_HOST_DEVICE __host__ __device__
#else
#define ALPHASCOPE_HOST_DEVICE
#endif

// For small functions in hot loops, which must be inlined.
#ifdef __CUDACC__
#define ALPHASCOPE_INLINE __host__ __device__ __forceinline__
#else
#define ALPHASCOPE_INLINE inline __attribute__((always_inline))
#endif

// For large functions that many places of a kernel call. Inlining all of them makes the compiler
// slow.
#ifdef __CUDACC__
#define ALPHASCOPE_DEVICE_CALL inline __host__ __device__ __noinline__
#else
#define ALPHASCOPE_DEVICE_CALL inline
#endif
