// SPDX-License-Identifier: GPL-3.0-or-later
// The answer of an engine to a request. It does not change once it is handed over.
#pragma once

#include <memory>
#include <string>

#include "core/complex/alpha_complex.hpp"
#include "core/document/settings/request.hpp"
#include "core/engine/known_results.hpp"

namespace alphascope {

struct BallSet;
struct MeasuredUnion;
struct Molecule;
struct PreparedBalls;

struct EngineAnswer {
  Request request;
  std::shared_ptr<const BallSet> balls;  // with the solvent radius, as the engine saw them
  AlphaComplex complex;
  std::string note;   // about the choice of engine and rounding on the lattice; may be empty
  bool cold = false;  // the engine's first answer, with its set-up
  // Set where measures were wanted and a device made them. Otherwise null, and the CPU may measure.
  std::shared_ptr<const MeasuredUnion> measures = {};
  // Wall time in which a device found AlphaComplex::outside for drawing. 0 where none did.
  double outer_faces_milliseconds = 0;
};

// The answer for an open molecule.
struct Answer : EngineAnswer {
  std::shared_ptr<const Molecule> molecule;       // with an assembly's copies
  std::shared_ptr<const PreparedBalls> prepared;  // its balls, without solvent radius
  // Triangulation and filtration that the engine made on the way, until the store takes them. Only
  // the main thread uses them.
  std::shared_ptr<ResultsForAllAlphas> made = std::make_shared<ResultsForAllAlphas>();
  std::uint64_t kept_bytes = 0;  // held by the session's engines for later answers
};

}  // namespace alphascope
