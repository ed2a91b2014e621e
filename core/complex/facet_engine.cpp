// The CPU engine: facet clipping while alpha is small.
#include <tbb/task_arena.h>

#include <cmath>
#include <stdexcept>

#include "core/complex/cpu_facets.hpp"
#include "core/complex/engine.hpp"
#include "core/geometry/coincident.hpp"

namespace alphascope {
namespace {

class FacetEngine : public Engine {
 public:
  FacetEngine(std::shared_ptr<const BallSet> balls, EngineOptions options)
      : balls_(std::move(balls)),
        arena_(options.threads > 0 ? options.threads : tbb::task_arena::automatic) {}

  AlphaComplex compute(const AlphaRequest& request, const RunContext& context) override {
    if (std::isnan(request.alpha_angstrom2)) throw std::invalid_argument("alpha is not a number");
    AlphaComplex complex;
    complex.lattice = balls_->lattice;
    complex.alpha_on_lattice = balls_->lattice.alpha_on_lattice(request.alpha_angstrom2);
    complex.tetrahedra_only = request.tetrahedra_only;
    arena_.execute([&] { facets(context, complex); });
    complex.hash = complex_hash(complex);
    return complex;
  }

 private:
  void facets(const RunContext& context, AlphaComplex& complex) {
    StageTimer timer(complex.timings);
    if (!hidden_known_) {
      hidden_ = coincident_hidden(*balls_);
      hidden_known_ = true;
      timer.lap("coincident centres", true);
    }
    context.report(stage::kGrid, 0);
    const UniformGrid grid = make_uniform_grid(*balls_, complex.alpha_on_lattice, hidden_);
    timer.lap(stage::kGrid);
    compute_facets(*balls_, grid, context, timer, complex);
    timer.finish();
    complex.engine = {"facet engine", "CPU, " + std::to_string(arena_.max_concurrency()) + (arena_.max_concurrency() == 1 ? " thread" : " threads"), "facet clipping"};
  }

  std::shared_ptr<const BallSet> balls_;
  tbb::task_arena arena_;
  std::vector<bool> hidden_;
  bool hidden_known_ = false;
};

}  // namespace

std::unique_ptr<Engine> make_cpu_engine(std::shared_ptr<const BallSet> balls, EngineOptions options) {
  return std::make_unique<FacetEngine>(std::move(balls), options);
}

}  // namespace alphascope
