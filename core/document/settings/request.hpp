// What one complex is asked for with: alpha, solvent radius and engine. Which atoms are balls is
// not said here.
#pragma once

#include "core/engine/engine_choice.hpp"
#include "core/geometry/alpha.hpp"
#include "core/tuples/tuple_options.hpp"

namespace alphascope {

// A change of these needs a new computation.
struct Request {
  Alpha alpha_angstrom2;               // Å²
  double solvent_radius_angstrom = 0;  // Å
  bool tetrahedra_only = false;        // the thesis' sub-complex
  EngineChoice engine = EngineChoice::automatic;
  int threads = 0;           // 0: as many as the machine has
  TupleOptions tuples = {};  // of the tuple engines only
  friend bool operator==(const Request&, const Request&) = default;
};

// Whether one engine answers both when the balls are the same.
inline bool same_engine(const Request& a, const Request& b) {
  return a.engine == b.engine && a.threads == b.threads && a.tuples == b.tuples;
}

// Also the solvent radius: whether set-up for one is set-up for the other.
inline bool same_setup(const Request& a, const Request& b) {
  return a.solvent_radius_angstrom == b.solvent_radius_angstrom && same_engine(a, b);
}

// Without what its engine does not look at, so that equal work is an equal request.
Request canonical(Request request);

}  // namespace alphascope
