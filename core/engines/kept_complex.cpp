#include "core/engines/kept_complex.hpp"

#include <new>

namespace alphascope {

void KeptComplex::keep(const AlphaComplex& complex) {
  filtration_.reset();
  try {
    top_ = std::make_shared<AlphaComplex>(complex);
  } catch (const std::bad_alloc&) {
    top_.reset();
  }
}

void KeptComplex::forget() {
  top_.reset();
  filtration_.reset();
}

std::uint64_t KeptComplex::bytes() const {
  const std::uint64_t top = top_ ? bytes_of(*top_) : 0;
  return filtration_ ? filtration_->top_bytes() + filtration_->level_bytes() : top;
}

std::optional<AlphaComplex> KeptComplex::answer(const LatticeAlpha& alpha, bool tetrahedra_only,
                                                const RunContext& context, StageTimer& timer) {
  const bool make_filtration = top_ && alpha <= top_->alpha_on_lattice;
  if (make_filtration) {
    filtration_.emplace(balls_, top_, context);
    top_.reset();
    timer.lap(stage::kClassification, true);
  }
  if (!filtration_ || !(alpha <= filtration_->alpha_max_on_lattice())) return std::nullopt;
  AlphaComplex complex = threshold(*filtration_, alpha, tetrahedra_only);
  complex.engine.route = make_filtration ? "filtration of cached complex, then threshold"
                                         : "threshold of cached filtration";
  timer.lap(stage::kThreshold);
  return complex;
}

}  // namespace alphascope
