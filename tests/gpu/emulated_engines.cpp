// SPDX-License-Identifier: GPL-3.0-or-later
// Engines of the emulated device, which is slow, for the suites that every engine must pass.
#include "gpu/tuples/tuple_engine.hpp"
#include "tests/support/device_engine.hpp"
#include "tests/support/engines.hpp"

namespace alphascope::testing {

std::vector<EngineFactory> engines() {
  // Several streams, and batches so small that small sets need several.
  TupleOptions batches;
  batches.streams = 3;
  batches.tuples_per_batch = 700;
  const auto tuples = [batches](auto balls) {
    return make_gpu_tuple_engine(std::move(balls), batches, nullptr);
  };
  return {
      {"emulated_gpu", [](auto balls) { return make_device_engine(std::move(balls)); }, 150, 1e5},
      {"emulated_gpu_tuples", tuples, 30, 1e6}};
}

}  // namespace alphascope::testing
