// What cavities come to at other alphas, with other solvent radii and in other models: samples, and
// which cavity of each sample is which of a table.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "core/cavity_identity/cavity_identity.hpp"

namespace alphascope {

enum class CurveAxis { alpha, solvent, model };

struct CurveCavity {
  std::array<BallIndex, 4> sink;  // its deepest
  bool is_void = false;
  double volume_sa_angstrom3 = 0, area_sa_angstrom2 = 0;
  double volume_exact_angstrom3 = 0;  // ClippedMeasures'; CurveNumbers::exact only
};

// What is known of each cavity. Exact volumes take about twenty times as long as all the rest.
enum class CurveNumbers { sums, exact };

struct CurveSample {
  double at = 0;                      // Å², Å, or the index of a model
  bool known = false;                 // false: this model does not have the atoms
  std::vector<CurveCavity> cavities;  // as Cavities::cavities
  // alpha, solvent: from the sample before to this one. Empty for the first.
  CavityMatch from_last;
  // solvent, model: to find the cavities of a table here.
  CavityRegions regions;
};

struct CavityCurves {
  CurveAxis axis = CurveAxis::alpha;
  CurveNumbers numbers = CurveNumbers::sums;
  std::vector<CurveSample> samples;  // `at` ascends

  std::size_t nearest(double at) const;  // there must be a sample
};

// All work in the caller's task arena, give the same for any number of threads, and throw
// Cancelled. Alphas and radii ascend.

// Of one triangulation.
CavityCurves curves_against_alpha(const std::shared_ptr<const CavityGround>& ground,
                                  double solvent_radius_angstrom,
                                  const std::vector<double>& alphas_angstrom2,
                                  const RunContext& context = {},
                                  CurveNumbers numbers = CurveNumbers::sums);

// `balls` without a solvent radius: a triangulation for each.
CavityCurves curves_against_solvent(const BallSet& balls, const Alpha& alpha_angstrom2,
                                    const std::vector<double>& radii_angstrom,
                                    const RunContext& context = {},
                                    CurveNumbers numbers = CurveNumbers::sums);

// The balls of each model, with the solvent radius and with the same indices; null where a model
// does not have them. No identity from model to model: cavities of a molecule that moves close and
// open again.
using ModelBalls = std::function<std::shared_ptr<const BallSet>(std::size_t model)>;
CavityCurves curves_against_model(std::size_t models, const ModelBalls& balls,
                                  const CavityQuestion& question, const RunContext& context = {},
                                  CurveNumbers numbers = CurveNumbers::sums);

// Where the cavities of one table are on curves. alpha: the sample's cavity of the same deepest
// sink. solvent: from the sample nearest to the table on, to both sides, as long as it is the same
// one (CavityMatch). model: the cavity that shares most tetrahedra of the same balls, if it shares
// most with that one, too.
struct CurveLinks {
  // [cavity of the table][sample]: the sample's cavity, or CavityMatch::kNone.
  std::vector<std::vector<std::uint32_t>> of;
};
// `table` at the place `at` of the axis. Throws Cancelled.
CurveLinks link_curves(const CavityCurves& curves, const CavityTable& table, double at,
                       const CancelToken& cancel = {});

// Into how many cavities one of the sample before comes apart here, and of how many one of this
// sample is made: 1 where nothing happens, 0 for kNone and the first sample.
std::size_t parts_at(const CurveSample& sample, std::uint32_t cavity_before);
std::size_t sources_at(const CurveSample& sample, std::uint32_t cavity);

}  // namespace alphascope
