// SPDX-License-Identifier: GPL-3.0-or-later
// A stand-in for CUDA's runtime. Device code is plain C++, and "device memory" is the host's. Grids
// run on the CPU, block after block, with every thread of a block as a fiber. Streams are queues
// whose work is put off until something waits for it. It is then done in an awkward order: the
// newest stream first, the oldest first, or at random, in changing turns. Events are respected. So
// kernels and their callers are tested on machines without a GPU, also under AddressSanitizer.
// Device resources that were never freed fail the program. It cannot replace a device: blocks do
// not run at the same time. Warps run in lockstep only at their collective operations, and kernels
// can read the host's memory.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <type_traits>

#define __host__
#define __device__
#define __global__ inline  // tests include headers with kernels, too
#define __noinline__
#define __launch_bounds__(...)
#define __align__(bytes) __attribute__((aligned(bytes)))
// Blocks run one at a time, so a block's fibers share static variables.
#define __shared__ static

struct uint2 {
  unsigned x, y;
};
struct uint3 {
  unsigned x, y, z;
};
struct alignas(16) uint4 {
  unsigned x, y, z, w;
};
struct alignas(16) int4 {
  int x, y, z, w;
};
struct alignas(16) float4 {
  float x, y, z, w;
};
inline uint2 make_uint2(unsigned x, unsigned y) {
  return {x, y};
}
inline uint3 make_uint3(unsigned x, unsigned y, unsigned z) {
  return {x, y, z};
}
inline uint4 make_uint4(unsigned x, unsigned y, unsigned z, unsigned w) {
  return {x, y, z, w};
}
inline int4 make_int4(int x, int y, int z, int w) {
  return {x, y, z, w};
}
inline float4 make_float4(float x, float y, float z, float w) {
  return {x, y, z, w};
}

// ---- grids -------------------------------------------------------------------------------------

extern uint3 threadIdx, blockIdx, blockDim, gridDim;

struct EmulatedStream;
struct EmulatedEvent;

namespace emulated {

// Queues a grid in which every thread runs the body; see cudaGetLastError().
void launch(unsigned blocks, unsigned threads, std::size_t shared_bytes, EmulatedStream* stream,
            std::function<void()> body);
unsigned char* shared_memory();

// Queued work: see EmulatedStream.
void enqueue(EmulatedStream* stream, std::function<void()> work);

// Waits until all threads of the block, or of the warp, have arrived.
void wait_for_block();
void wait_for_warp();
// The values that all lanes of the warp passed, valid until the next exchange.
const std::uint64_t* exchange(std::uint64_t own);

template <class T>
std::uint64_t bits_of(T value) {
  static_assert(sizeof(T) <= 8);
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof value);
  return bits;
}
template <class T>
T value_of(std::uint64_t bits) {
  T value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}
inline int lane() {
  return static_cast<int>(threadIdx.x & 31);
}
template <class T>
T shuffle(T own, int from) {
  return value_of<T>(exchange(bits_of(own))[from]);
}

}  // namespace emulated

inline void __syncthreads() {
  emulated::wait_for_block();
}
inline int __syncthreads_or(int own) {
  static int any;
  if (threadIdx.x == 0) any = 0;
  __syncthreads();
  if (own) any = 1;
  __syncthreads();
  const int result = any;
  __syncthreads();
  return result;
}
inline void __syncwarp() {
  emulated::wait_for_warp();
}
template <class T>
T __shfl_sync(unsigned, T own, int from) {
  return emulated::shuffle(own, from & 31);
}
template <class T>
T __shfl_up_sync(unsigned, T own, int by, int width = 32) {
  const int lane = emulated::lane();
  return emulated::shuffle(own, lane % width >= by ? lane - by : lane);
}
template <class T>
T __shfl_xor_sync(unsigned, T own, int mask) {
  return emulated::shuffle(own, emulated::lane() ^ mask);
}
inline unsigned __ballot_sync(unsigned, bool own) {
  const std::uint64_t* all = emulated::exchange(own ? 1 : 0);
  unsigned bits = 0;
  for (unsigned lane = 0; lane < 32; ++lane) bits |= static_cast<unsigned>(all[lane]) << lane;
  return bits;
}
inline bool __any_sync(unsigned mask, bool own) {
  return __ballot_sync(mask, own) != 0;
}

// Fibers share one thread, so nothing happens between reading and writing.
template <class T>
T atomicAdd(T* to, std::type_identity_t<T> value) {
  const T old = *to;
  *to = old + value;
  return old;
}
template <class T>
T atomicMax(T* to, std::type_identity_t<T> value) {
  const T old = *to;
  *to = std::max(old, value);
  return old;
}
template <class T>
T atomicMin(T* to, std::type_identity_t<T> value) {
  const T old = *to;
  *to = std::min(old, value);
  return old;
}
template <class T>
T atomicAnd(T* to, std::type_identity_t<T> value) {
  const T old = *to;
  *to = old & value;
  return old;
}
template <class T>
T atomicOr(T* to, std::type_identity_t<T> value) {
  const T old = *to;
  *to = old | value;
  return old;
}

template <class T>
T atomicCAS(T* to, std::type_identity_t<T> expected, std::type_identity_t<T> value) {
  const T old = *to;
  if (old == expected) *to = value;
  return old;
}
inline void __threadfence() {}
template <class T>
T __ldcg(const T* from) {
  return *from;
}

inline int __popc(unsigned bits) {
  return std::popcount(bits);
}
inline int __ffs(int bits) {
  return __builtin_ffs(bits);
}
inline int __ffsll(long long bits) {
  return bits == 0 ? 0 : std::countr_zero(static_cast<unsigned long long>(bits)) + 1;
}
inline unsigned __float_as_uint(float value) {
  return std::bit_cast<unsigned>(value);
}
inline float __uint_as_float(unsigned bits) {
  return std::bit_cast<float>(bits);
}
inline long long __double_as_longlong(double value) {
  return std::bit_cast<long long>(value);
}
template <class A, class B>
constexpr std::common_type_t<A, B> min(A a, B b) {
  return b < a ? b : a;
}
template <class A, class B>
constexpr std::common_type_t<A, B> max(A a, B b) {
  return a < b ? b : a;
}

// ---- runtime -----------------------------------------------------------------------------------

enum cudaError_t {
  cudaSuccess,
  cudaErrorInvalidValue,
  cudaErrorMemoryAllocation,
  cudaErrorInvalidConfiguration,
  cudaErrorInvalidResourceHandle,
  cudaErrorNotReady,
  cudaErrorDevicesUnavailable,
  cudaErrorInsufficientDriver
};
enum cudaMemcpyKind { cudaMemcpyHostToDevice, cudaMemcpyDeviceToHost, cudaMemcpyDeviceToDevice };
enum cudaDeviceAttr {
  cudaDevAttrMaxSharedMemoryPerBlockOptin,
  cudaDevAttrMaxSharedMemoryPerMultiprocessor,
  cudaDevAttrMultiProcessorCount
};
enum cudaFuncAttribute { cudaFuncAttributeMaxDynamicSharedMemorySize };
enum { cudaStreamNonBlocking, cudaEventDefault, cudaEventDisableTiming };
#define CUDART_VERSION 12000
using cudaStream_t = EmulatedStream*;
using cudaEvent_t = EmulatedEvent*;
struct cudaDeviceProp {
  char name[64];
  std::size_t totalGlobalMem;
  int major, minor;
};

namespace emulated {

// The status of this call: an error when a test has set the device as lost by now (device.h). Calls
// that free resources never fail, and queries about the device are always answered.
cudaError_t status();

}  // namespace emulated

// For launches. All other calls return their own errors.
cudaError_t cudaGetLastError();
inline const char* cudaGetErrorString(cudaError_t) {
  return "an emulated error";
}
inline cudaError_t cudaGetDeviceCount(int* count) {
  *count = 1;
  return cudaSuccess;
}
inline cudaError_t cudaDriverGetVersion(int* version) {
  *version = CUDART_VERSION;
  return cudaSuccess;
}
inline cudaError_t cudaGetDevice(int* device) {
  *device = 0;
  return emulated::status();
}
inline cudaError_t cudaGetDeviceProperties(cudaDeviceProp* p, int) {
  *p = {"emulated device", std::size_t{1} << 30, 9, 0};
  return cudaSuccess;
}
// Values of a laptop's device, so that cases with little shared memory occur as well.
inline cudaError_t cudaDeviceGetAttribute(int* value, cudaDeviceAttr attribute, int) {
  *value = attribute == cudaDevAttrMultiProcessorCount                ? 2
           : attribute == cudaDevAttrMaxSharedMemoryPerMultiprocessor ? 100 * 1024
                                                                      : 99 * 1024;
  return emulated::status();
}
template <class Kernel>
cudaError_t cudaFuncSetAttribute(Kernel, cudaFuncAttribute, int) {
  return emulated::status();
}

namespace emulated {

// Memory is filled with implausible values, as a device's may be.
enum class MemoryKind { device, pinned, registered };
cudaError_t allocate(void** data, std::size_t bytes, MemoryKind kind);
// As on a device, all work is done before memory is freed.
cudaError_t release(void* data, MemoryKind kind);

}  // namespace emulated

template <class T>
cudaError_t cudaMalloc(T** data, std::size_t bytes) {
  return emulated::allocate(reinterpret_cast<void**>(data), bytes, emulated::MemoryKind::device);
}
template <class T>
cudaError_t cudaMallocHost(T** data, std::size_t bytes) {
  return emulated::allocate(reinterpret_cast<void**>(data), bytes, emulated::MemoryKind::pinned);
}
// Fails every other time, as on systems that cannot register memory.
enum { cudaHostRegisterDefault };
cudaError_t cudaHostRegister(void* data, std::size_t bytes, unsigned flags);
cudaError_t cudaHostUnregister(void* data);
cudaError_t cudaDeviceSynchronize();
inline cudaError_t cudaFree(void* data) {
  return emulated::release(data, emulated::MemoryKind::device);
}
inline cudaError_t cudaFreeHost(void* data) {
  return emulated::release(data, emulated::MemoryKind::pinned);
}
// Three quarters of the memory are always free.
inline cudaError_t cudaMemGetInfo(std::size_t* free, std::size_t* all) {
  *all = std::size_t{1} << 30;
  *free = *all / 4 * 3;
  return cudaSuccess;
}
// Copies of any memory are put off. A device may copy pageable memory at once, but need not.
cudaError_t cudaMemcpyAsync(void* to, const void* from, std::size_t bytes, cudaMemcpyKind kind,
                            cudaStream_t stream);
inline cudaError_t cudaMemcpy(void* to, const void* from, std::size_t bytes, cudaMemcpyKind kind) {
  return cudaMemcpyAsync(to, from, bytes, kind, nullptr);
}
inline cudaError_t cudaMemsetAsync(void* to, int byte, std::size_t bytes, cudaStream_t stream) {
  if (const cudaError_t status = emulated::status()) return status;
  emulated::enqueue(stream, [=] {
    if (bytes > 0) std::memset(to, byte, bytes);
  });
  return cudaSuccess;
}
inline cudaError_t cudaDeviceGetStreamPriorityRange(int* least, int* greatest) {
  *least = *greatest = 0;
  return emulated::status();
}
cudaError_t cudaStreamCreateWithPriority(cudaStream_t* stream, unsigned flags, int priority);
// Does not wait. The stream's work is still done.
cudaError_t cudaStreamDestroy(cudaStream_t stream);
cudaError_t cudaStreamSynchronize(cudaStream_t stream);
cudaError_t cudaStreamWaitEvent(cudaStream_t stream, cudaEvent_t event, unsigned flags);
cudaError_t cudaEventCreateWithFlags(cudaEvent_t* event, unsigned flags);
inline cudaError_t cudaEventCreate(cudaEvent_t* event) {
  return cudaEventCreateWithFlags(event, cudaEventDefault);
}
cudaError_t cudaEventRecord(cudaEvent_t event, cudaStream_t stream);
cudaError_t cudaEventSynchronize(cudaEvent_t event);
cudaError_t cudaEventElapsedTime(float* milliseconds, cudaEvent_t start, cudaEvent_t end);
cudaError_t cudaEventDestroy(cudaEvent_t event);

#include "texture.h"
