// SPDX-License-Identifier: GPL-3.0-or-later
// The tuple engine (core/tuples/tuple_engine.hpp) on a CUDA device. This header is plain C++.
#pragma once

#include <memory>
#include <string>

#include "core/engine/engine.hpp"
#include "core/tuples/tuple_options.hpp"

namespace alphascope {

// Returns null if the device cannot be used (see gpu_device()), and sets *why_not to the reason.
// Never falls back to the CPU, because the engine is meant for the device. In compute() a failure
// of the device throws std::runtime_error, and full memory std::bad_alloc. The engine stays usable.
std::unique_ptr<Engine> make_gpu_tuple_engine(std::shared_ptr<const BallSet> balls,
                                              TupleOptions tuples, std::string* why_not);

}  // namespace alphascope
