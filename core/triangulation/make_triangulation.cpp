// SPDX-License-Identifier: GPL-3.0-or-later
// Chooses between insertion and CGAL, and writes the report.
#include "core/triangulation/make_triangulation.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/insertion/insertion.hpp"
#include "core/run/stage_timer.hpp"
#include "core/run/work_threads.hpp"
#include "core/triangulation/cgal_triangulation.hpp"
#include "core/triangulation/triangulation_report.hpp"

namespace alphascope {

Triangulation make_triangulation(const BallSet& balls, int threads, const RunContext& context) {
  using By = TriangulationReport::By;
  TriangulationReport report;
  StageTimer timer(report.timings);
  InsertionCounts counts;
  const int here = threads_here();
  threads = threads > 0 ? std::min(threads, here) : here;
  std::optional<Triangulation> made = triangulate_by_insertion(balls, threads, context, &counts);
  Triangulation result = made ? *std::move(made) : make_cgal_triangulation(balls, threads, context);
  report.by = made ? By::insertion : By::cgal;
  report.maker = made ? cpu_text(counts.threads) : "CGAL";
  report.inserters = counts.inserters;
  report.put_off = counts.put_off;
  timer.lap(stage::kTriangulation);
  timer.finish();
  result.report = std::make_shared<const TriangulationReport>(std::move(report));
  return result;
}

}  // namespace alphascope
