// SPDX-License-Identifier: GPL-3.0-or-later
// The request for one complex: alpha, solvent radius and engine. It does not contain the choice of
// atoms.
#pragma once

#include "core/engine/engine_choice.hpp"
#include "core/geometry/alpha.hpp"
#include "core/tuples/tuple_options.hpp"

namespace alphascope {

// A change of a request needs a new computation.
struct Request {
  Alpha alpha_angstrom2;               // Å²
  double solvent_radius_angstrom = 0;  // Å
  bool tetrahedra_only = false;        // the thesis' sub-complex
  EngineChoice engine = EngineChoice::automatic;
  int threads = 0;           // 0: all threads of the machine
  TupleOptions tuples = {};  // for the tuple engines only
  friend bool operator==(const Request&, const Request&) = default;
};

// Sets alpha, Å²; values beyond kAlphaRule's bounds become the nearest bound. Keys, buttons and
// playback, which raise or lower it in steps, use this.
void set_alpha(Request& request, const Alpha& angstrom2);

// Whether one engine can answer both requests for the same balls.
inline bool same_engine(const Request& a, const Request& b) {
  return a.engine == b.engine && a.threads == b.threads && a.tuples == b.tuples;
}

// Also compares the solvent radius: whether the set-up for one request serves the other.
inline bool same_setup(const Request& a, const Request& b) {
  return a.solvent_radius_angstrom == b.solvent_radius_angstrom && same_engine(a, b);
}

// The request with default values for options that its engine does not use. So requests with equal
// work are equal.
Request canonical(Request request);

}  // namespace alphascope
