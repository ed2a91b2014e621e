// SPDX-License-Identifier: GPL-3.0-or-later
// Makes engines of the executors of a GPU library.
#include "core/engines/gpu_library.hpp"

#include <exception>
#include <utility>

#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice_alpha.hpp"

namespace alphascope {

std::unique_ptr<Engine> make_gpu_engine(const GpuLibrary& library,
                                        std::shared_ptr<const BallSet> balls, EngineOptions options,
                                        std::string* why_not, GpuOptions gpu_options) {
  const GpuDevice& device = library.device();
  std::string reason = device.why_not;
  if (device.usable) {
    try {
      return make_engine_of_executors(
          std::move(balls), options,
          [make = library.make_executor, gpu_options](std::shared_ptr<const BallSet> of) {
            return make(std::move(of), gpu_options);
          });
    } catch (const std::exception& error) {
      reason = device.name + " cannot take this molecule: " + error.what() +
               ". The CPU engine gives the same results.";
    }
  }
  if (why_not != nullptr) *why_not = reason;
  return nullptr;
}

}  // namespace alphascope
