// SPDX-License-Identifier: GPL-3.0-or-later
// Engines of a device, for the suites that every engine must pass.
#include "gpu/tuples/tuple_engine.hpp"
#include "tests/support/device_engine.hpp"
#include "tests/support/engines.hpp"

namespace alphascope::testing {

std::vector<EngineFactory> engines() {
  const std::string why_not = gpu_device().usable ? "" : gpu_device().why_not;
  const auto tuples = [](auto balls) {
    return make_gpu_tuple_engine(std::move(balls), {}, nullptr);
  };
  return {{"gpu", [](auto balls) { return make_device_engine(std::move(balls)); }, 1000,
           std::numeric_limits<double>::infinity(), why_not},
          {"gpu_tuples", tuples, 35, 3e6, why_not}};
}

}  // namespace alphascope::testing
