// SPDX-License-Identifier: GPL-3.0-or-later
// The runtime of the emulated device: faults, streams, memory and textures. See cuda_runtime.h.
#include <cuda_runtime.h>

#include <chrono>
#include <cstdio>
#include <deque>
#include <map>
#include <memory>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

#include "tests/gpu/emulated/device.h"
#include "tests/gpu/emulated/grids.h"

namespace emulated {
namespace {

cudaError_t last_error = cudaSuccess;

// Countdowns to the faults that tests have set. Below 0: never.
struct Faults {
  int allocations_until_full = -1, calls_until_lost = -1, met = 0;
  bool is_full = false;

  // True when an attempt to reserve memory must fail.
  bool refuses() {
    if (is_full) return true;
    if (allocations_until_full < 0 || allocations_until_full-- != 0) return false;
    ++met;
    return is_full = true;
  }
} faults;
ToHost to_host;

}  // namespace

cudaError_t status() {
  faults.is_full = false;
  if (faults.calls_until_lost < 0) return cudaSuccess;
  if (faults.calls_until_lost > 0) {
    --faults.calls_until_lost;
    return cudaSuccess;
  }
  ++faults.met;
  return cudaErrorDevicesUnavailable;
}
void be_full_at(int reservation) {
  faults = {};
  faults.allocations_until_full = reservation;
}
void be_lost_at(int call) {
  faults = {};
  faults.calls_until_lost = call;
}
int faults_met() {
  return faults.met;
}
void be_sound() {
  faults = {};
  to_host = nullptr;
}
void change_copies_to_host(ToHost change) {
  to_host = std::move(change);
}

void launch(unsigned blocks, unsigned threads, std::size_t shared_bytes, EmulatedStream* stream,
            std::function<void()> body) {
  if (blocks == 0 || threads == 0 || threads > 1024) {
    last_error = cudaErrorInvalidConfiguration;
    return;
  }
  if (const cudaError_t now = status()) {
    last_error = now;
    return;
  }
  enqueue(stream, [=, own = std::move(body)] { run_grid(blocks, threads, shared_bytes, own); });
}

}  // namespace emulated

// ---- streams -----------------------------------------------------------------------------------

using Clock = std::chrono::steady_clock;

struct EmulatedEvent {
  // How often the event was recorded, how many recordings were reached, and when the last one was.
  // Work that is put off may need this after the event.
  struct Recordings {
    unsigned made = 0, reached = 0;
    Clock::time_point when;
    bool are_reached() const { return reached >= made; }
  };
  std::shared_ptr<Recordings> recordings = std::make_shared<Recordings>();
  bool is_timed = true;
};

struct EmulatedStream {
  struct Task {
    std::function<void()> work;
    std::shared_ptr<const EmulatedEvent::Recordings> after;  // or null
    unsigned recording;                                      // of `after`
    bool is_ready() const { return after == nullptr || after->reached >= recording; }
  };
  std::deque<Task> tasks;
  bool is_destroyed = false;
};

namespace emulated {
namespace {

std::vector<std::unique_ptr<EmulatedStream>> streams;
int events = 0;
enum class Order { newest_first, oldest_first, by_lot } order = Order::newest_first;
std::minstd_rand lots;  // for orders in which work is done

std::size_t drawn(std::size_t most) {
  return (lots() >> 8) % most;
}

// Does one task. False when no task can be done.
bool step() {
  const std::size_t count = streams.size();
  const std::size_t first = order == Order::by_lot && count > 0 ? drawn(count) : 0;
  for (std::size_t n = 0; n < count; ++n) {
    auto& tasks =
        streams[order == Order::newest_first ? count - 1 - n : (first + n) % count]->tasks;
    if (tasks.empty() || !tasks.front().is_ready()) continue;
    const std::function<void()> work = std::move(tasks.front().work);
    tasks.pop_front();
    if (work) work();
    return true;
  }
  return false;
}
bool is_idle() {
  return std::all_of(streams.begin(), streams.end(),
                     [](const auto& s) { return s->tasks.empty(); });
}
void drop_destroyed() {
  std::erase_if(streams, [](const auto& s) { return s->is_destroyed && s->tasks.empty(); });
}
template <class Done>
void step_until(const Done& done) {
  const bool was_idle = is_idle();
  while (!done()) {
    if (!step()) throw std::logic_error("streams wait for events that are never reached");
  }
  if (!was_idle && is_idle()) order = static_cast<Order>(drawn(3));
  drop_destroyed();
}
void finish_all() {
  step_until(is_idle);
}

}  // namespace

void enqueue(EmulatedStream* stream, std::function<void()> work) {
  if (stream != nullptr) {
    stream->tasks.push_back({std::move(work), nullptr, 0});
    return;
  }
  finish_all();
  work();
}

}  // namespace emulated

cudaError_t cudaGetLastError() {
  return std::exchange(emulated::last_error, cudaSuccess);
}

cudaError_t cudaStreamCreateWithPriority(cudaStream_t* stream, unsigned, int) {
  if (const cudaError_t status = emulated::status()) return status;
  *stream = emulated::streams.emplace_back(std::make_unique<EmulatedStream>()).get();
  return cudaSuccess;
}
cudaError_t cudaStreamDestroy(cudaStream_t stream) {
  emulated::faults.is_full = false;
  stream->is_destroyed = true;
  emulated::drop_destroyed();
  return cudaSuccess;
}
cudaError_t cudaStreamSynchronize(cudaStream_t stream) {
  if (const cudaError_t status = emulated::status()) return status;
  emulated::step_until([&] { return stream->tasks.empty(); });
  return cudaSuccess;
}
// Waits for the event's latest recording at this moment.
cudaError_t cudaStreamWaitEvent(cudaStream_t stream, cudaEvent_t event, unsigned) {
  if (const cudaError_t status = emulated::status()) return status;
  stream->tasks.push_back({nullptr, event->recordings, event->recordings->made});
  return cudaSuccess;
}
cudaError_t cudaEventCreateWithFlags(cudaEvent_t* event, unsigned flags) {
  if (const cudaError_t status = emulated::status()) return status;
  *event = new EmulatedEvent;
  ++emulated::events;
  (*event)->is_timed = flags != cudaEventDisableTiming;
  return cudaSuccess;
}
cudaError_t cudaEventRecord(cudaEvent_t event, cudaStream_t stream) {
  if (const cudaError_t status = emulated::status()) return status;
  const unsigned recording = ++event->recordings->made;
  emulated::enqueue(stream, [recording, of = event->recordings] {
    of->reached = recording;
    of->when = Clock::now();
  });
  return cudaSuccess;
}
cudaError_t cudaEventSynchronize(cudaEvent_t event) {
  if (const cudaError_t status = emulated::status()) return status;
  emulated::step_until([&] { return event->recordings->are_reached(); });
  return cudaSuccess;
}
cudaError_t cudaEventElapsedTime(float* milliseconds, cudaEvent_t start, cudaEvent_t end) {
  if (const cudaError_t status = emulated::status()) return status;
  for (const EmulatedEvent* e : {start, end}) {
    if (!e->is_timed || e->recordings->made == 0) return cudaErrorInvalidResourceHandle;
    if (!e->recordings->are_reached()) return cudaErrorNotReady;
  }
  const auto between = end->recordings->when - start->recordings->when;
  *milliseconds = std::chrono::duration<float, std::milli>(between).count();
  return cudaSuccess;
}
cudaError_t cudaEventDestroy(cudaEvent_t event) {
  delete event;
  --emulated::events;
  return cudaSuccess;
}

// ---- memory ------------------------------------------------------------------------------------

namespace emulated {
namespace {

struct Allocation {
  std::size_t bytes;
  MemoryKind kind;
};
std::map<std::uintptr_t, Allocation> allocations;

bool is_on_device(const void* data, std::size_t bytes) {
  const auto begin = reinterpret_cast<std::uintptr_t>(data);
  const auto after = allocations.upper_bound(begin);
  if (after == allocations.begin()) return false;
  const auto& [start, allocation] = *std::prev(after);
  return allocation.kind == MemoryKind::device && begin - start + bytes <= allocation.bytes;
}

}  // namespace

cudaError_t allocate(void** data, std::size_t bytes, MemoryKind kind) {
  *data = nullptr;
  if (bytes == 0) return cudaSuccess;
  if (faults.refuses()) return cudaErrorMemoryAllocation;
  if (const cudaError_t now = status()) return now;
  if (posix_memalign(data, 256, bytes) != 0) return cudaErrorMemoryAllocation;
  std::memset(*data, 0xa5, bytes);
  allocations[reinterpret_cast<std::uintptr_t>(*data)] = {bytes, kind};
  return cudaSuccess;
}
cudaError_t release(void* data, MemoryKind kind) {
  faults.is_full = false;
  if (data == nullptr) return cudaSuccess;
  const auto found = allocations.find(reinterpret_cast<std::uintptr_t>(data));
  if (found == allocations.end() || found->second.kind != kind) return cudaErrorInvalidValue;
  finish_all();
  allocations.erase(found);
  if (kind != MemoryKind::registered) std::free(data);
  return cudaSuccess;
}

std::size_t pinned_bytes() {
  std::size_t sum = 0;
  for (const auto& [at, of] : allocations) sum += of.kind == MemoryKind::device ? 0 : of.bytes;
  return sum;
}
std::size_t registered_bytes() {
  std::size_t sum = 0;
  for (const auto& [at, of] : allocations) sum += of.kind == MemoryKind::registered ? of.bytes : 0;
  return sum;
}

}  // namespace emulated

cudaError_t cudaHostRegister(void* data, std::size_t bytes, unsigned) {
  static bool refused = false;
  refused = !refused;
  if (refused) return emulated::last_error = cudaErrorInvalidValue;
  if (emulated::faults.refuses()) return emulated::last_error = cudaErrorMemoryAllocation;
  if (const cudaError_t status = emulated::status()) return emulated::last_error = status;
  std::memset(data, 0xa5, bytes);
  emulated::allocations[reinterpret_cast<std::uintptr_t>(data)] = {
      bytes, emulated::MemoryKind::registered};
  return cudaSuccess;
}
cudaError_t cudaHostUnregister(void* data) {
  return emulated::release(data, emulated::MemoryKind::registered);
}
cudaError_t cudaDeviceSynchronize() {
  emulated::finish_all();
  return cudaSuccess;
}

cudaError_t cudaMemcpyAsync(void* to, const void* from, std::size_t bytes, cudaMemcpyKind kind,
                            cudaStream_t stream) {
  if (const cudaError_t status = emulated::status()) return status;
  if (bytes == 0) return cudaSuccess;
  const bool to_device = kind != cudaMemcpyDeviceToHost,
             from_device = kind != cudaMemcpyHostToDevice;
  if (emulated::is_on_device(to, bytes) != to_device) return cudaErrorInvalidValue;
  if (emulated::is_on_device(from, bytes) != from_device) return cudaErrorInvalidValue;
  emulated::enqueue(stream, [=] {
    std::memcpy(to, from, bytes);
    if (!to_device && emulated::to_host) emulated::to_host(to, bytes);
  });
  return cudaSuccess;
}

// ---- textures ----------------------------------------------------------------------------------

namespace emulated {

// By object. Destroyed ones and the first one have no elements.
std::vector<Texture> textures(1);

}  // namespace emulated

cudaError_t cudaCreateTextureObject(cudaTextureObject_t* object, const cudaResourceDesc* resource,
                                    const cudaTextureDesc* texture, const cudaResourceViewDesc*) {
  if (const cudaError_t status = emulated::status()) return status;
  const auto& linear = resource->res.linear;
  const auto element =
      static_cast<std::size_t>(linear.desc.x + linear.desc.y + linear.desc.z + linear.desc.w) / 8;
  if (resource->resType != cudaResourceTypeLinear || linear.sizeInBytes < element ||
      texture->readMode != cudaReadModeElementType ||
      !emulated::is_on_device(linear.devPtr, linear.sizeInBytes)) {
    return cudaErrorInvalidValue;
  }
  *object = emulated::textures.size();
  emulated::textures.push_back({linear.devPtr, linear.sizeInBytes / element, linear.desc});
  return cudaSuccess;
}
cudaError_t cudaDestroyTextureObject(cudaTextureObject_t object) {
  emulated::textures.at(object) = {};
  return cudaSuccess;
}

// ---- the end -----------------------------------------------------------------------------------

namespace emulated {
namespace {

// Ends the program with an error when any device resource was never freed.
const struct Leaks {
  ~Leaks() {
    const auto is_there = [](const Texture& t) { return t.count > 0; };
    const char* left = !allocations.empty()                                      ? "memory"
                       : !streams.empty()                                        ? "a stream"
                       : events > 0                                              ? "an event"
                       : std::any_of(textures.begin(), textures.end(), is_there) ? "a texture"
                                                                                 : nullptr;
    if (left == nullptr) return;
    std::fprintf(stderr, "%s of the emulated device was never given back\n", left);
    std::_Exit(EXIT_FAILURE);
  }
} leaks;

}  // namespace
}  // namespace emulated
