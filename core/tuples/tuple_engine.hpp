// SPDX-License-Identifier: GPL-3.0-or-later
// The pipeline of the thesis as an engine: grid, tuples of neighbours, filtered and exact validity.
// It is exact, as every engine is. It shows the thesis' own algorithm and the effect of its
// optimisations, and is not meant to be fast. gpu/tuples/tuple_engine.hpp is the engine of the CUDA
// executor.
#pragma once

#include "core/engine/engine.hpp"
#include "core/tuples/tuple_options.hpp"

namespace alphascope {

// Makes the engine on the CPU (oneTBB). Options for the CUDA executor are ignored.
std::unique_ptr<Engine> make_tuple_engine(std::shared_ptr<const BallSet> balls,
                                          EngineOptions options = {}, TupleOptions tuples = {});

}  // namespace alphascope
