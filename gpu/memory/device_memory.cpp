// SPDX-License-Identifier: GPL-3.0-or-later
// Counts the device memory that is held, and keeps it within the limit.
#include "gpu/memory/device_memory.hpp"

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "gpu/memory/device_allocation.hpp"

namespace alphascope::gpu {
namespace {

std::atomic<std::size_t> limit_bytes{0}, held_bytes{0}, most_bytes{0};

}  // namespace

cudaError_t allocate_device_memory(void** memory, std::size_t bytes) {
  const std::size_t now = held_bytes.fetch_add(bytes) + bytes;
  const std::size_t most_allowed = limit_bytes;
  const cudaError_t status = most_allowed != 0 && now > most_allowed ? cudaErrorMemoryAllocation
                                                                     : cudaMalloc(memory, bytes);
  if (status != cudaSuccess) {
    held_bytes -= bytes;
    return status;
  }
  std::size_t most = most_bytes;
  while (most < now && !most_bytes.compare_exchange_weak(most, now)) {
  }
  return status;
}

void free_device_memory(void* memory, std::size_t bytes) {
  if (memory == nullptr) return;
  cudaFree(memory);
  held_bytes -= bytes;
}

cudaError_t device_memory_room(std::size_t* free, std::size_t* all) {
  const cudaError_t status = cudaMemGetInfo(free, all);
  const std::size_t most_allowed = limit_bytes, now = held_bytes;
  if (status != cudaSuccess || most_allowed == 0) return status;
  *all = std::min(*all, most_allowed);
  *free = std::min(*free, most_allowed - std::min(most_allowed, now));
  return status;
}

std::size_t DeviceMemory::held() {
  return held_bytes;
}

std::size_t DeviceMemory::most_held() {
  return most_bytes;
}

void DeviceMemory::forget_most() {
  most_bytes = held_bytes.load();
}

std::size_t DeviceMemory::limit() {
  return limit_bytes;
}

void DeviceMemory::set_limit(std::size_t bytes) {
  limit_bytes = bytes;
}

std::string DeviceMemory::read_limit() {
  constexpr std::uint64_t kMegabyte = 1'000'000, kMost = 1'000'000'000;
  const char* const value = std::getenv("ALPHASCOPE_GPU_MEMORY");
  if (value == nullptr || *value == '\0') return {};
  const std::string_view text = value;
  std::uint64_t megabytes = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), megabytes);
  if (error != std::errc() || end != text.data() + text.size() || megabytes == 0 ||
      megabytes > kMost)
    return "ALPHASCOPE_GPU_MEMORY is no whole number of megabytes above 0: " + std::string(text);
  set_limit(megabytes * kMegabyte);
  return {};
}

}  // namespace alphascope::gpu
