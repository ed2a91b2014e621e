// Marks functions that both the CPU executor and the CUDA executor compile.
#pragma once

#ifdef __CUDACC__
#define ALPHASCOPE_HOST_DEVICE __host__ __device__
#else
#define ALPHASCOPE_HOST_DEVICE
#endif

// For hot leaves that must vanish into their loop.
#ifdef __CUDACC__
#define ALPHASCOPE_INLINE __host__ __device__ __forceinline__
#else
#define ALPHASCOPE_INLINE inline __attribute__((always_inline))
#endif

// For large leaves that many places of a kernel call: inlined everywhere, they make the compiler
// slow.
#ifdef __CUDACC__
#define ALPHASCOPE_DEVICE_CALL inline __host__ __device__ __noinline__
#else
#define ALPHASCOPE_DEVICE_CALL inline
#endif
