// SPDX-License-Identifier: GPL-3.0-or-later
// The part that the tuple engines of both executors share: from a request to its complex.
#pragma once

#include <cmath>
#include <optional>
#include <stdexcept>

#include "core/engine/engine.hpp"
#include "core/neighbours/coincident.hpp"
#include "core/tuples/tuple_pipeline.hpp"

namespace alphascope {

// Counters for display: the numbers of tuples after each step.
std::vector<EngineCounter> tuple_counters(const TupleCounts& counts);
// The name of the route, with the options that are switched off: "tuples of neighbours, without
// edge optimisation and ...".
std::string tuple_route(const TupleOptions& options, bool on_gpu);

// The tuple engine for one set of balls on one executor. Beyond tuple_pipeline.hpp, an executor
// provides take_times() -> StageTimes, and host_memory(), a std::pmr::memory_resource* for the
// grid.
template <class Executor>
class TupleComputer {
 public:
  TupleComputer(std::shared_ptr<const BallSet> balls, TupleOptions options, Executor& executor)
      : balls_(std::move(balls)),
        options_(options),
        executor_(executor),
        grid_(executor.host_memory()),
        pipeline_(executor) {}

  // Engine::compute(), except for name and device in EngineInfo.
  AlphaComplex compute(const AlphaRequest& request, const RunContext& context) {
    if (std::isnan(request.alpha_angstrom2.nearest()))
      throw std::invalid_argument("alpha is not a number");
    AlphaComplex complex;
    complex.lattice = balls_->lattice;
    complex.alpha_on_lattice = balls_->lattice.alpha_on_lattice(request.alpha_angstrom2);
    complex.tetrahedra_only = request.tetrahedra_only;
    StageTimes times;
    StageTimer timer(times);
    if (!hidden_) {
      hidden_ = coincident_hidden(*balls_);
      timer.lap(stage::kCoincident, true);
    }
    context.report(stage::kGrid, 0);
    executor_.reset();  // a run that threw may still be copying from the grid
    make_tuple_grid(*balls_, complex.alpha_on_lattice, *hidden_, options_.grid, grid_);
    timer.lap(stage::kGrid);
    TupleFindings found =
        pipeline_.run(grid_, options_, complex.alpha_on_lattice, !request.tetrahedra_only, context);
    timer.adopt(executor_.take_times());
    context.cancel.throw_if_cancelled();
    context.report(stage::kClassification, 0);
    complete_complex(std::move(found.own), balls_->size(), complex);
    timer.lap(stage::kClassification);
    complex.hash = complex_hash(complex);
    timer.lap(stage::kHash);
    timer.finish();
    complex.timings = std::move(times);
    complex.engine.route = tuple_route(options_, Executor::kOnGpu);
    complex.engine.counters = tuple_counters(found.counts);
    return complex;
  }

 private:
  std::shared_ptr<const BallSet> balls_;
  const TupleOptions options_;
  Executor& executor_;
  TupleGrid grid_;
  TuplePipeline<Executor> pipeline_;
  std::optional<std::vector<bool>> hidden_;
};

}  // namespace alphascope
