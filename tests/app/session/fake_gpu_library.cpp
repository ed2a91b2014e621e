// SPDX-License-Identifier: GPL-3.0-or-later
// Stand-ins for the library with the GPU engines, for tests of its loading: a good one; with
// FAKE_OLD_GPU one of another build; with FAKE_FOREIGN one without its symbols.
#include <atomic>
#include <cstdlib>
#include <optional>

#include "core/engines/gpu_library.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/run/cancel_token.hpp"
#include "core/run/library_build.hpp"

namespace alphascope {
namespace {

std::atomic<bool> unused{true};

// Fails for a negative alpha. All other requests are beyond its limits.
class FakeExecutor : public Executor {
 public:
  std::optional<AlphaComplex> compute(const AlphaRequest& request, const RunContext&) override {
    if (request.alpha_angstrom2.nearest() < 0) throw ExecutorFailed("the fake GPU is lost");
    return std::nullopt;
  }
};

const GpuDevice& device() {
  static const GpuDevice fake = {.usable = true, .name = "Fake GPU"};
  return fake;
}
std::unique_ptr<Executor> make_executor(std::shared_ptr<const BallSet>, const GpuOptions&) {
  return std::make_unique<FakeExecutor>();
}
std::unique_ptr<Engine> make_tuple_engine(std::shared_ptr<const BallSet>, TupleOptions,
                                          std::string* why_not) {
  *why_not = "The fake GPU has no tuples.";
  return nullptr;
}
std::unique_ptr<DeviceTriangulator> make_triangulator(FindSeed) {
  throw ExecutorFailed("The fake GPU makes no triangulations");
}
bool is_memory_unused() {
  return unused;
}
void free_unused_memory() {
  unused = false;
}

[[maybe_unused]] constexpr GpuLibrary kTable = {
    device,           make_executor,     make_tuple_engine, make_triangulator,
    is_memory_unused, free_unused_memory};

}  // namespace
}  // namespace alphascope

#ifndef FAKE_FOREIGN
extern "C" {

__attribute__((visibility("default"))) const char* alphascope_gpu_build() {
#ifdef FAKE_OLD_GPU
  return "0.0.1 0123456789abcdef GCC 4.9";
#else
  return alphascope::library_build();
#endif
}

// Nobody may call this function of another build.
__attribute__((visibility("default"))) const alphascope::GpuLibrary* alphascope_gpu_library() {
#ifdef FAKE_OLD_GPU
  std::abort();
#else
  return &alphascope::kTable;
#endif
}
}
#endif
