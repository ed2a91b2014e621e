// The thesis' own pipeline as an engine: grid, tuples of neighbours, filtered and exact validity.
// Exact as every engine; for fidelity, teaching and ablation, not for speed. The CUDA executor's
// engine is gpu/tuples/tuple_engine.hpp.
#pragma once

#include "core/engine/engine.hpp"
#include "core/tuples/tuple_options.hpp"

namespace alphascope {

// On the CPU (oneTBB). Options of the CUDA executor are ignored.
std::unique_ptr<Engine> make_tuple_engine(std::shared_ptr<const BallSet> balls,
                                          EngineOptions options = {}, TupleOptions tuples = {});

}  // namespace alphascope
