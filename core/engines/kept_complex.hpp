// The last whole complex of an engine that does not triangulate: smaller alphas are thresholds.
#pragma once

#include <memory>
#include <optional>

#include "core/complex/alpha_complex.hpp"
#include "core/engine/engine.hpp"
#include "core/run/cancel_token.hpp"
#include "core/triangulation/filtration.hpp"

namespace alphascope {

class KeptComplex {
 public:
  explicit KeptComplex(std::shared_ptr<const BallSet> balls) : balls_(std::move(balls)) {}

  // Copies a whole complex of these balls. A result is worth more than its copy: when memory is
  // short, nothing is kept.
  void keep(const AlphaComplex& complex);
  void forget();
  std::uint64_t bytes() const;

  // K_alpha with its route, if alpha is not above that of the complex. The first answer makes a
  // filtration of it, which is setup. Works in the caller's task arena. Throws Cancelled, and
  // std::bad_alloc; both leave everything as it was.
  std::optional<AlphaComplex> answer(const LatticeAlpha& alpha_on_lattice, bool tetrahedra_only,
                                     const RunContext& context, StageTimer& timer);

 private:
  std::shared_ptr<const BallSet> balls_;
  // At most one of the two: a whole complex not yet made a filtration, or the filtration.
  std::shared_ptr<const AlphaComplex> top_;
  std::optional<Filtration> filtration_;
};

}  // namespace alphascope
