// SPDX-License-Identifier: GPL-3.0-or-later
// The reference engine. It makes CGAL's triangulation once, and takes every alpha from it while the
// caller keeps it. cgal_triangulation.cpp makes the triangulation, filtration.hpp the alpha values.
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

#include "core/complex/count_limits.hpp"
#include "core/engine/engine.hpp"
#include "core/engines/answers_from_known.hpp"
#include "core/engines/by_triangulation.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/triangulation/filtration.hpp"
#include "core/triangulation/triangulation_report.hpp"

namespace alphascope {
namespace {

// This engine answers from CGAL's triangulations only.
void forget_others(KnownResults& known) {
  if (known.triangulation && !made_by_cgal(*known.triangulation)) known.triangulation = nullptr;
  if (known.filtration && !known.filtration->top().engine.rests_on_cgal) known.filtration = nullptr;
}

class CgalEngine : public Engine {
 public:
  CgalEngine(std::shared_ptr<const BallSet> balls, const EngineOptions& options)
      : balls_(std::move(balls)), threads_(options.work_threads()) {}

  AlphaComplex compute(const AlphaRequest& request, KnownResults& known,
                       const RunContext& context) override {
    if (std::isnan(request.alpha_angstrom2.nearest()))
      throw std::invalid_argument("alpha is not a number");
    require_known_of(*balls_, known);
    forget_others(known);
    AlphaComplex complex;
    StageTimes times;
    threads_->run([&] {
      StageTimer timer(times);
      auto answer = threshold_of_filtration(*balls_, request, known, context, timer);
      complex = answer ? *std::move(answer)
                       : compute_by_triangulation({balls_, nullptr, threads_->asked(), true},
                                                  request, known, context, timer);
      timer.finish();
    });
    complex.timings = std::move(times);
    complex.engine.name = "CGAL triangulation";
    complex.engine.device = threads_->text();
    return complex;
  }

 private:
  std::shared_ptr<const BallSet> balls_;
  std::shared_ptr<WorkThreads> threads_;
};

}  // namespace

std::unique_ptr<Engine> make_cgal_engine(std::shared_ptr<const BallSet> balls,
                                         EngineOptions options) {
  require_balls(balls->size());
  return std::make_unique<CgalEngine>(std::move(balls), options);
}

}  // namespace alphascope
