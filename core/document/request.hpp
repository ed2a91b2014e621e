// What one complex is asked for with: alpha, solvent radius and engine. Which atoms are balls is not
// said here.
#pragma once

#include "core/engine/engine_choice.hpp"
#include "core/tuples/tuple_options.hpp"

namespace alphascope {

// A change of these needs a new computation.
struct Request {
  double alpha_angstrom2 = 0;          // Å²
  double solvent_radius_angstrom = 0;  // Å
  bool tetrahedra_only = false;        // the thesis' sub-complex
  EngineChoice engine = EngineChoice::automatic;
  int threads = 0;           // 0: as many as the machine has
  TupleOptions tuples = {};  // of the tuple engines only
  friend bool operator==(const Request&, const Request&) = default;
};

// Without what its engine does not look at, so that equal work is an equal request.
inline Request canonical(Request request) {
  const TupleOptions asked = request.tuples;
  request.tuples = {};
  if (!is_tuple_engine(request.engine)) return request;
  request.tuples = asked;
  if (request.engine == EngineChoice::tuples_gpu) return request;
  const TupleOptions defaults;
  request.tuples.pinned = defaults.pinned;
  request.tuples.texture = defaults.texture;
  request.tuples.streams = defaults.streams;
  return request;
}

}  // namespace alphascope
