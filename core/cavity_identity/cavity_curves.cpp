// SPDX-License-Identifier: GPL-3.0-or-later
// Samples the cavities along an axis of alpha, solvent radius or model. Links the cavities of a
// table to the samples.
#include "core/cavity_identity/cavity_curves.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/cavity/cavities.hpp"
#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/cavity_measures.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/complex/alpha_complex.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/predicates/flow_predicate.hpp"
#include "core/run/stage_timer.hpp"
#include "core/triangulation/filtration.hpp"
#include "core/triangulation/make_triangulation.hpp"

namespace alphascope {
namespace {

constexpr std::uint32_t kNone = CavityMatch::kNone;

CurveSample sample_of(double at, const CavityTable& table,
                      const std::vector<ExactCavityMeasures>& exact = {}) {
  CurveSample sample;
  sample.at = at;
  sample.known = true;
  for (std::size_t c = 0; c < table.found.cavities.size(); ++c) {
    const Cavity& cavity = table.found.cavities[c];
    const CavityMeasures& m = table.measures[c];
    sample.cavities.push_back({table.ground->triangulation->tetrahedra[cavity.deepest_sink],
                               cavity.is_void(), m.volume_sa_angstrom3, m.area_sa_angstrom2,
                               exact.empty() ? 0 : exact[c].volume_sa_angstrom3,
                               cavity.mouths.size()});
  }
  return sample;
}

CurveSample sample_with(double at, const CavityTable& table, CurveNumbers numbers,
                        const CancelToken& cancel) {
  if (numbers == CurveNumbers::sums) return sample_of(at, table);
  return sample_of(at, table, measure_all_exactly(table, RunContext{cancel, {}}));
}

CavityTable table_of_balls(std::shared_ptr<const BallSet> balls, const CavityParameters& question,
                           const CancelToken& cancel) {
  const RunContext quiet{cancel, {}};  // reports nothing: progress is counted in samples
  auto triangulation = std::make_shared<const Triangulation>(make_triangulation(*balls, 1, quiet));
  const auto ground = std::make_shared<const CavityGround>(
      make_cavity_ground(std::move(balls), std::move(triangulation), FlowTies::perturbed, quiet));
  return make_cavity_table(ground, question, quiet);
}

void report(const RunContext& context, std::size_t done, std::size_t all) {
  context.cancel.throw_if_cancelled();
  context.report(stage::kCavities, static_cast<double>(done) / static_cast<double>(all));
}

using BySink = std::map<std::array<BallIndex, 4>, std::uint32_t>;

CurveLinks link_by_sinks(const CavityCurves& curves, const CavityTable& table) {
  CurveLinks links;
  const CurveSample self = sample_of(0, table);
  links.of.assign(self.cavities.size(), std::vector<std::uint32_t>(curves.samples.size(), kNone));
  for (std::size_t n = 0; n < curves.samples.size(); ++n) {
    BySink by_sink;
    const std::vector<CurveCavity>& there = curves.samples[n].cavities;
    for (std::uint32_t c = 0; c < there.size(); ++c) by_sink.emplace(there[c].sink, c);
    for (std::size_t c = 0; c < self.cavities.size(); ++c) {
      const auto found = by_sink.find(self.cavities[c].sink);
      if (found != by_sink.end()) links.of[c][n] = found->second;
    }
  }
  return links;
}

// For each cavity of the table the index of the same cavity in a sample, or kNone.
std::vector<std::uint32_t> same_in(const CurveSample& sample, const CavityRegions& table,
                                   const BallSet& balls) {
  std::vector<std::uint32_t> same(table.sinks.size(), kNone);
  if (!sample.known) return same;
  const CavityMatch match = match_regions(sample.regions, table, balls);
  for (std::uint32_t c = 0; c < same.size(); ++c) {
    if (match.is_same(c)) same[c] = match.came_from[c];
  }
  return same;
}

CurveLinks link_by_radius(const CavityCurves& curves, const CavityTable& table, double at) {
  const std::vector<CurveSample>& samples = curves.samples;
  const std::size_t start = curves.nearest(at);
  const std::vector<std::uint32_t> here =
      same_in(samples[start], regions_of(table), *table.ground->balls);
  CurveLinks links;
  links.of.assign(here.size(), std::vector<std::uint32_t>(samples.size(), kNone));
  for (std::size_t c = 0; c < here.size(); ++c) {
    std::vector<std::uint32_t>& line = links.of[c];
    line[start] = here[c];
    for (std::size_t n = start; n + 1 < samples.size() && line[n] != kNone; ++n) {
      const CavityMatch& on = samples[n + 1].from_last;
      const std::uint32_t next = on.goes_to[line[n]];
      if (next != kNone && on.is_same(next)) line[n + 1] = next;
    }
    for (std::size_t n = start; n > 0 && line[n] != kNone; --n) {
      const CavityMatch& back = samples[n].from_last;
      if (back.is_same(line[n])) line[n - 1] = back.came_from[line[n]];
    }
  }
  return links;
}

CurveLinks link_models(const CavityCurves& curves, const CavityTable& table,
                       const CancelToken& cancel) {
  const CavityRegions regions = regions_of(table);
  CurveLinks links;
  links.of.assign(regions.sinks.size(), std::vector<std::uint32_t>(curves.samples.size(), kNone));
  for (std::size_t n = 0; n < curves.samples.size(); ++n) {
    cancel.throw_if_cancelled();
    const auto same = same_in(curves.samples[n], regions, *table.ground->balls);
    for (std::size_t c = 0; c < same.size(); ++c) links.of[c][n] = same[c];
  }
  return links;
}

}  // namespace

std::size_t CavityCurves::nearest(double at) const {
  const auto nearer = [&](const CurveSample& a, const CurveSample& b) {
    return std::fabs(a.at - at) < std::fabs(b.at - at);
  };
  return static_cast<std::size_t>(std::min_element(samples.begin(), samples.end(), nearer) -
                                  samples.begin());
}

CavityCurves curves_against_alpha(const std::shared_ptr<const CavityGround>& ground,
                                  double solvent_radius_angstrom,
                                  const std::vector<double>& alphas_angstrom2,
                                  const RunContext& context, CurveNumbers numbers) {
  CavityCurves curves;
  curves.numbers = numbers;
  CavityTable last;
  for (const double alpha : alphas_angstrom2) {
    report(context, curves.samples.size(), alphas_angstrom2.size());
    CavityTable table =
        make_cavity_table(ground, {alpha, solvent_radius_angstrom}, RunContext{context.cancel, {}});
    curves.samples.push_back(sample_with(alpha, table, numbers, context.cancel));
    if (last.ground) curves.samples.back().from_last = match_cavities(last, table, context.cancel);
    last = std::move(table);
  }
  return curves;
}

CavityCurves curves_against_solvent(const BallSet& balls, const Alpha& alpha_angstrom2,
                                    const std::vector<double>& radii_angstrom,
                                    const RunContext& context, CurveNumbers numbers) {
  CavityCurves curves;
  curves.numbers = numbers;
  curves.axis = CurveAxis::solvent;
  CavityTable last;
  for (const double radius : radii_angstrom) {
    report(context, curves.samples.size(), radii_angstrom.size());
    CavityTable table = table_of_balls(std::make_shared<const BallSet>(with_solvent(balls, radius)),
                                       {alpha_angstrom2, radius}, context.cancel);
    curves.samples.push_back(sample_with(radius, table, numbers, context.cancel));
    curves.samples.back().regions = regions_of(table);
    if (last.ground) curves.samples.back().from_last = match_cavities(last, table, context.cancel);
    last = std::move(table);
  }
  return curves;
}

CavityCurves curves_against_model(std::size_t models, const ModelBalls& balls,
                                  const CavityParameters& question, const RunContext& context,
                                  CurveNumbers numbers) {
  CavityCurves curves;
  curves.numbers = numbers;
  curves.axis = CurveAxis::model;
  for (std::size_t model = 0; model < models; ++model) {
    report(context, model, models);
    auto set = balls(model);
    CurveSample sample;
    if (set) {
      const CavityTable table = table_of_balls(std::move(set), question, context.cancel);
      sample = sample_with(0, table, numbers, context.cancel);
      sample.regions = regions_of(table);
    }
    sample.at = static_cast<double>(model);
    curves.samples.push_back(std::move(sample));
  }
  return curves;
}

CurveLinks link_curves(const CavityCurves& curves, const CavityTable& table, double at,
                       const CancelToken& cancel) {
  if (curves.samples.empty()) return {};
  if (curves.axis == CurveAxis::alpha) return link_by_sinks(curves, table);
  if (curves.axis == CurveAxis::solvent) return link_by_radius(curves, table, at);
  return link_models(curves, table, cancel);
}

std::size_t parts_at(const CurveSample& sample, std::uint32_t cavity_before) {
  if (cavity_before == kNone) return 0;
  return sample.from_last.parts(cavity_before).size();
}

std::size_t sources_at(const CurveSample& sample, std::uint32_t cavity) {
  if (cavity == kNone || sample.from_last.goes_to.empty()) return 0;
  return sample.from_last.sources(cavity).size();
}

}  // namespace alphascope
