// The tuple engine (core/tuples/tuple_engine.hpp) on a CUDA device. Plain C++: the program builds
// and runs without CUDA.
#pragma once

#include <memory>
#include <string>

#include "core/engine/engine.hpp"
#include "core/tuples/tuple_options.hpp"

namespace alphascope {

// Null when the device cannot be used (see gpu_device()): *why_not then says why. Never falls back
// to the CPU: what it is for is the device. compute() throws std::runtime_error when that fails,
// std::bad_alloc when its memory is full; the engine stays usable.
std::unique_ptr<Engine> make_gpu_tuple_engine(std::shared_ptr<const BallSet> balls,
                                              TupleOptions tuples, std::string* why_not);

}  // namespace alphascope
