// What an engine answered a request with; immutable once handed over.
#pragma once

#include <memory>
#include <string>

#include "core/complex/alpha_complex.hpp"
#include "core/document/settings/request.hpp"
#include "core/engine/engine.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/measure/engine_measures.hpp"
#include "core/selection/prepare_balls.hpp"

namespace alphascope {

struct EngineAnswer {
  Request request;
  std::shared_ptr<const BallSet> balls;  // with the solvent radius: what the engine saw
  AlphaComplex complex;
  std::string note;   // about the choice of engine and rounding on the lattice; may be empty
  bool cold = false;  // the engine's first answer, and it had to set up
  // Where they were wanted and the engine has a device; else null, and the CPU may measure.
  std::shared_ptr<const MeasuredUnion> measures = {};
  // Wall time that a device took to find AlphaComplex::outside, for the picture; 0 where none did.
  double outside_milliseconds = 0;
};

// Of an open molecule.
struct Answer : EngineAnswer {
  std::shared_ptr<const Molecule> molecule;       // with an assembly's copies
  std::shared_ptr<const PreparedBalls> prepared;  // its balls, without solvent radius
  // What the engine made of all balls on the way, until the store takes it. Of the main thread.
  std::shared_ptr<OfAllBalls> made = std::make_shared<OfAllBalls>();
  std::uint64_t kept_bytes = 0;  // by the engines of the session, for later answers
};

}  // namespace alphascope
