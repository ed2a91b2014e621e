// The reference engine: CGAL's whole triangulation once, then every alpha from it. The
// triangulation itself is cgal_triangulation.cpp's, the alpha values filtration.hpp's.
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "core/complex/count_limits.hpp"
#include "core/engine/engine.hpp"
#include "core/engines/lent.hpp"
#include "core/predicates/exact_alpha.hpp"
#include "core/run/parallel.hpp"
#include "core/triangulation/cgal_triangulation.hpp"
#include "core/triangulation/filtration.hpp"

namespace alphascope {
namespace {

// CGAL's own route to the tetrahedra of K_alpha: all cells with ortho-radius <= alpha.
void filter_tetrahedra(const BallSet& balls, const Triangulation& triangulation,
                       AlphaComplex& complex) {
  const Simplices<4>& cells = triangulation.tetrahedra;
  std::vector<char> in(cells.size());
  constexpr std::size_t kGrain = 1024;
  parallel_ranges(0, cells.size(), kGrain, [&](std::size_t first, std::size_t end) {
    for (std::size_t c = first; c != end; ++c) {
      in[c] = compare_ortho_radius(balls, cells[c], complex.alpha_on_lattice) <= 0;
    }
  });
  SimplexList<4>& list = complex.tetrahedra;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (in[c]) list.simplices.push_back(cells[c]);
  }
}

class CgalEngine : public Engine {
 public:
  CgalEngine(std::shared_ptr<const BallSet> balls, EngineOptions options)
      : balls_(std::move(balls)), threads_(options.work_threads()) {}

  AlphaComplex compute(const AlphaRequest& request, const RunContext& context) override {
    if (std::isnan(request.alpha_angstrom2.nearest()))
      throw std::invalid_argument("alpha is not a number");
    require_lent_of(*balls_, request.lent);
    AlphaComplex complex;
    StageTimes times;
    threads_->run([&] {
      StageTimer timer(times);
      std::optional<AlphaComplex> answer = threshold_of_lent(*balls_, request, context, timer);
      complex = answer ? *std::move(answer) : own_answer(request, context, timer);
      timer.finish();
    });
    drop_what_was_lent(request.lent);
    complex.timings = std::move(times);
    complex.engine.name = "CGAL triangulation";
    complex.engine.device = threads_->text();
    complex.engine.rests_on_cgal = true;
    return complex;
  }

  Lent take() override {
    return {std::exchange(triangulation_, nullptr), std::exchange(filtration_, nullptr)};
  }

  std::uint64_t kept_bytes() const override { return bytes_of(Lent{triangulation_, filtration_}); }

 private:
  AlphaComplex own_answer(const AlphaRequest& request, const RunContext& context,
                          StageTimer& timer) {
    const LatticeAlpha alpha = balls_->lattice.alpha_on_lattice(request.alpha_angstrom2);
    const std::string route = next_route(request);
    std::shared_ptr<const Triangulation> triangulation;
    if (!filtration_) triangulation = lent_or_made(request.lent, context, timer);
    if (!filtration_ && !request.tetrahedra_only) {
      filtration_ = request.handing_over
                        ? std::make_shared<const Filtration>(balls_, triangulation, context)
                        : std::make_shared<const Filtration>(balls_, *triangulation, context);
      if (!request.handing_over) triangulation_.reset();  // the filtration replaces it
      timer.lap(stage::kClassification, true);
    }
    context.report(stage::kThreshold, 0);
    context.cancel.throw_if_cancelled();
    AlphaComplex complex = filtration_ ? threshold(*filtration_, alpha, request.tetrahedra_only)
                                       : filtered_tetrahedra(*triangulation, alpha);
    complex.engine.route = route;
    timer.lap(stage::kThreshold);
    return complex;
  }

  // What own_answer() is about to do.
  std::string next_route(const AlphaRequest& request) const {
    if (filtration_) return "threshold of cached filtration";
    const std::string source = request.lent.triangulation ? "the whole triangulation"
                               : triangulation_           ? "cached triangulation"
                                                          : "";
    if (request.tetrahedra_only) {
      return source.empty() ? "regular triangulation, then threshold" : "threshold of " + source;
    }
    return source.empty() ? "regular triangulation, filtration, then threshold"
                          : "filtration of " + source + ", then threshold";
  }

  std::shared_ptr<const Triangulation> lent_or_made(const Lent& lent, const RunContext& context,
                                                    StageTimer& timer) {
    if (lent.triangulation) return lent.triangulation;
    if (!triangulation_) {
      triangulation_ = std::make_shared<const Triangulation>(
          make_triangulation(*balls_, threads_->asked(), context));
      timer.lap(stage::kTriangulation, true);
    }
    return triangulation_;
  }

  // Somebody else keeps the same.
  void drop_what_was_lent(const Lent& lent) {
    if (lent.triangulation || lent.filtration) triangulation_.reset();
    if (lent.filtration) filtration_.reset();
  }

  AlphaComplex filtered_tetrahedra(const Triangulation& triangulation,
                                   const LatticeAlpha& alpha) const {
    AlphaComplex complex;
    complex.lattice = balls_->lattice;
    complex.alpha_on_lattice = alpha;
    complex.tetrahedra_only = true;
    filter_tetrahedra(*balls_, triangulation, complex);
    complex.hash = complex_hash(complex);
    return complex;
  }

  std::shared_ptr<const BallSet> balls_;
  std::shared_ptr<WorkThreads> threads_;
  // Each only while it is needed and nobody lends it.
  std::shared_ptr<const Triangulation> triangulation_;
  std::shared_ptr<const Filtration> filtration_;
};

}  // namespace

std::unique_ptr<Engine> make_cgal_engine(std::shared_ptr<const BallSet> balls,
                                         EngineOptions options) {
  require_balls(balls->size());
  return std::make_unique<CgalEngine>(std::move(balls), options);
}

}  // namespace alphascope
