// SPDX-License-Identifier: GPL-3.0-or-later
// Cavities at other alphas, with other solvent radii and in other models. The curves consist of
// samples. Links tell which cavity of a sample is which cavity of a table.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "core/cavity_identity/cavity_identity.hpp"
#include "core/geometry/ball_set.hpp"

namespace alphascope {

enum class CurveAxis { alpha, solvent, model };
struct CavityGround;
struct CavityParameters;

struct CurveCavity {
  std::array<BallIndex, 4> sink;  // its deepest sink
  bool is_void = false;
  double volume_sa_angstrom3 = 0, area_sa_angstrom2 = 0;
  double volume_exact_angstrom3 = 0;  // of ExactCavityMeasures; for CurveNumbers::exact only
  std::size_t mouths = 0;
};

// The volumes computed for each cavity. Exact volumes take about twenty times as long as all else.
enum class CurveNumbers { sums, exact };

struct CurveSample {
  double at = 0;       // alpha in Å², solvent radius in Å, or the index of a model
  bool known = false;  // false: the model lacks some of the atoms
  std::vector<CurveCavity> cavities;  // in the order of Cavities::cavities
  // For alpha and solvent: the match from the sample before to this one. Empty for the first
  // sample.
  CavityMatch from_last;
  // For solvent and model: used to find the cavities of a table in this sample.
  CavityRegions regions;
};

struct CavityCurves {
  CurveAxis axis = CurveAxis::alpha;
  CurveNumbers numbers = CurveNumbers::sums;
  std::vector<CurveSample> samples;  // `at` is ascending

  std::size_t nearest(double at) const;  // index of a sample; needs at least one
};

// These functions work in the caller's task arena. Their result does not depend on the number of
// threads. They throw Cancelled. Alphas and radii must ascend.

// All samples are of one triangulation.
CavityCurves curves_against_alpha(const std::shared_ptr<const CavityGround>& ground,
                                  double solvent_radius_angstrom,
                                  const std::vector<double>& alphas_angstrom2,
                                  const RunContext& context = {},
                                  CurveNumbers numbers = CurveNumbers::sums);

// `balls` are without a solvent radius. Each radius takes a triangulation.
CavityCurves curves_against_solvent(const BallSet& balls, const Alpha& alpha_angstrom2,
                                    const std::vector<double>& radii_angstrom,
                                    const RunContext& context = {},
                                    CurveNumbers numbers = CurveNumbers::sums);

// The balls of each model, with the solvent radius and the same indices; null if the model lacks
// some. Samples are not matched from model to model, because cavities of a molecule that moves
// close and open again.
using ModelBalls = std::function<std::shared_ptr<const BallSet>(std::size_t model)>;
CavityCurves curves_against_model(std::size_t models, const ModelBalls& balls,
                                  const CavityParameters& question, const RunContext& context = {},
                                  CurveNumbers numbers = CurveNumbers::sums);

// The samples' cavities that correspond to the cavities of one table.
// - alpha: the cavity with the same deepest sink.
// - solvent: followed from the sample nearest to the table to both sides, as long as CavityMatch
//   calls it the same.
// - model: the cavity that shares the largest volume in tetrahedra of the same balls, if this is
//   mutual.
struct CurveLinks {
  // [cavity of the table][sample]: index of the sample's cavity, or CavityMatch::kNone.
  std::vector<std::vector<std::uint32_t>> of;
};
// `table` is at position `at` of the axis. Throws Cancelled.
CurveLinks link_curves(const CavityCurves& curves, const CavityTable& table, double at,
                       const CancelToken& cancel = {});

// parts_at(): the number of cavities of this sample into which a cavity of the sample before
// splits. sources_at(): the number of cavities of the sample before that merge into a cavity of
// this one. 1 means no change. 0 for kNone and for the first sample.
std::size_t parts_at(const CurveSample& sample, std::uint32_t cavity_before);
std::size_t sources_at(const CurveSample& sample, std::uint32_t cavity);

}  // namespace alphascope
