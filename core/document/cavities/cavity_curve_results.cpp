// SPDX-License-Identifier: GPL-3.0-or-later
// Samples of the curves, their memory and keys, and balls of other models.
#include "core/document/cavities/cavity_curve_results.hpp"

#include <algorithm>
#include <cmath>

#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/store/derived.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/key.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/molecule/molecule.hpp"
#include "core/predicates/exact_rho.hpp"
#include "core/radii/radii_set.hpp"
#include "core/selection/prepare_balls.hpp"
#include "core/triangulation/memory_need.hpp"

namespace alphascope {
namespace {

constexpr double kAlphaHigh = 10;  // Å²

// Large triangulations get fewer samples. A sample takes about 0.4 microseconds for each
// tetrahedron, with exact volumes up to 20 times as much.
std::vector<double> alpha_samples(const CavityGround& ground, CurveNumbers numbers) {
  const bool exact = numbers == CurveNumbers::exact;
  const std::size_t tetrahedra = ground.triangulation->tetrahedra.size();
  const std::size_t cost = tetrahedra * (exact ? 20 : 1);
  const int per_square_angstrom = cost < 60'000 ? 20 : cost < 600'000 ? 10 : 2;
  const double kGrowth = exact ? 1.2 : 1.05;
  float filled = 0;
  for (std::size_t t = 0; t < tetrahedra; ++t) {
    if (ground.flow.is_sink(t)) filled = std::max(filled, ground.flow.alpha_values[t]);
  }
  const double last = ground.balls->lattice.square_angstrom(filled);
  std::vector<double> samples;
  for (int k = static_cast<int>(kCurveAlphaLeastAngstrom2) * per_square_angstrom;
       k <= static_cast<int>(kAlphaHigh) * per_square_angstrom; ++k) {
    samples.push_back(static_cast<double>(k) / per_square_angstrom);
  }
  constexpr std::size_t kMost = 1000;  // sinks of flat balls may have alpha values near the largest
                                       // float
  while (samples.back() < last && samples.size() < kMost) {
    samples.push_back(std::round(samples.back() * kGrowth * 100) / 100);
  }
  return samples;
}

std::vector<double> solvent_samples() {
  std::vector<double> radii;
  const long last = std::lround(kCurveSolventMostAngstrom / kCurveSolventStepAngstrom);
  const long per_angstrom = std::lround(1 / kCurveSolventStepAngstrom);
  for (long k = 0; k <= last; ++k) {
    radii.push_back(static_cast<double>(k) / static_cast<double>(per_angstrom));
  }
  return radii;
}

// Assumes 7 tetrahedra a ball. For 51 samples of 4HHB, 2.2 bytes a tetrahedron are kept on average.
MemoryNeed curve_memory(std::size_t balls, std::size_t samples, bool regions) {
  const std::uint64_t tetrahedra = 7 * std::uint64_t{balls};
  constexpr std::uint64_t kTable = 700;  // bytes a tetrahedron: two triangulations and tables
  const std::uint64_t held = samples * tetrahedra * ((regions ? 4 : 0) + 1) + 1'000'000;
  return {held, held + kTable * tetrahedra};
}

const ModelRange* range_of_shown(const BallReferences& atoms) {
  const std::vector<std::uint32_t>& of_ball = atoms.prepared().atom_of_ball;
  if (of_ball.empty()) return nullptr;
  for (const ModelRange& model : atoms.molecule().models) {
    if (of_ball.front() >= model.begin && of_ball.back() < model.end) return &model;
  }
  return nullptr;
}

bool same_atom(const Atom& a, const Atom& b) {
  return a.name == b.name && a.residue_name == b.residue_name && a.element == b.element &&
         same_residue_number(a, b);
}

std::uint64_t combined(std::uint64_t hash, std::uint64_t value) {
  return Key{hash, value, 1}.number();
}

template <CurveNumbers numbers>
Definition<CavityCurves> over_alpha(std::string_view id, std::string_view title) {
  return {
      {.id = id,
       .title = title,
       .made_of = {&cavity_ground()},
       .key = key_of_balls,
       .memory =
           [](const Inputs& in) {
             const auto samples = alpha_samples(in.of(cavity_ground()), numbers).size();
             return curve_memory(in.balls->size(), samples, false);
           }},
      [](const Inputs& in, const RunContext& context) {
        const auto ground = in.share(cavity_ground());
        return std::make_shared<const CavityCurves>(curves_against_alpha(
            ground, in.solvent_radius_angstrom, alpha_samples(*ground, numbers), context, numbers));
      }};
}

Key key_over_solvent(const Inputs& in) {
  if (!in.atoms) return Key{};
  Key key = key_of_balls_and_alpha(in);
  key.balls = in.body_key;
  return key;
}

template <CurveNumbers numbers>
Definition<CavityCurves> over_solvent(std::string_view id, std::string_view title) {
  return {
      {.id = id,
       .title = title,
       .key = key_over_solvent,
       .memory =
           [](const Inputs& in) {
             return curve_memory(in.balls->size(), solvent_samples().size(), true);
           }},
      [](const Inputs& in, const RunContext& context) {
        return std::make_shared<const CavityCurves>(curves_against_solvent(
            *in.atoms->prepared().balls, in.alpha_angstrom2, solvent_samples(), context, numbers));
      }};
}

Key key_over_models(const Inputs& in) {
  if (!in.atoms || in.frames_key == 0) return Key{};
  Key key = key_of_balls_and_alpha(in);
  key.balls = in.frames_key;
  const auto radius = static_cast<std::uint64_t>(std::llround(in.solvent_radius_angstrom * 1e9));
  key.more = Key{1, radius, 1}.number();
  return key;
}

template <CurveNumbers numbers>
Definition<CavityCurves> over_models(std::string_view id, std::string_view title) {
  return {{.id = id,
           .title = title,
           .key = key_over_models,
           .memory =
               [](const Inputs& in) {
                 return curve_memory(in.balls->size(), in.atoms->molecule().models.size(), true);
               }},
          [](const Inputs& in, const RunContext& context) {
            const double solvent = in.solvent_radius_angstrom;
            const auto balls = [&](std::size_t model) -> std::shared_ptr<const BallSet> {
              const auto bare = balls_in_model(*in.atoms, model);
              if (!bare) return nullptr;
              return std::make_shared<const BallSet>(with_solvent(*bare, solvent));
            };
            return std::make_shared<const CavityCurves>(
                curves_against_model(in.atoms->molecule().models.size(), balls,
                                     {in.alpha_angstrom2, solvent}, context, numbers));
          }};
}

}  // namespace

const Definition<CavityCurves>& curves_over_alpha(CurveNumbers numbers) {
  static const Definition<CavityCurves> sums =
      over_alpha<CurveNumbers::sums>("cavities.curves.alpha", "Cavities against alpha");
  static const Definition<CavityCurves> exact =
      over_alpha<CurveNumbers::exact>("cavities.curves.alpha.exact", "Exact volumes against alpha");
  return numbers == CurveNumbers::sums ? sums : exact;
}

const Definition<CavityCurves>& curves_over_solvent(CurveNumbers numbers) {
  static const Definition<CavityCurves> sums = over_solvent<CurveNumbers::sums>(
      "cavities.curves.solvent", "Cavities against the solvent radius");
  static const Definition<CavityCurves> exact = over_solvent<CurveNumbers::exact>(
      "cavities.curves.solvent.exact", "Exact volumes against the solvent radius");
  return numbers == CurveNumbers::sums ? sums : exact;
}

const Definition<CavityCurves>& curves_over_models(CurveNumbers numbers) {
  static const Definition<CavityCurves> sums =
      over_models<CurveNumbers::sums>("cavities.curves.models", "Cavities in all models");
  static const Definition<CavityCurves> exact = over_models<CurveNumbers::exact>(
      "cavities.curves.models.exact", "Exact volumes in all models");
  return numbers == CurveNumbers::sums ? sums : exact;
}

std::string why_no_model_curve(const Inputs& inputs) {
  if (!inputs.atoms) return "Open a molecule of several models.";
  if (inputs.atoms->molecule().models.size() < 2) return "This file has one model only.";
  if (!range_of_shown(*inputs.atoms)) {
    return "All models are on screen as one body. Choose a single model.";
  }
  return "";
}

std::size_t shown_model(const BallReferences& atoms) {
  return static_cast<std::size_t>(range_of_shown(atoms) - atoms.molecule().models.data());
}

std::shared_ptr<const BallSet> balls_in_model(const BallReferences& atoms, std::size_t model) {
  const Molecule& molecule = atoms.molecule();
  const ModelRange* shown = range_of_shown(atoms);
  if (!shown) return nullptr;
  const ModelRange& range = molecule.models.at(model);
  auto balls = std::make_shared<BallSet>(*atoms.prepared().balls);
  std::int32_t factor = 1;
  for (int k = molecule.lattice.digits; k < balls->lattice.digits; ++k) factor *= 10;
  for (std::size_t n = 0; n < balls->size(); ++n) {
    const std::size_t from = atoms.prepared().atom_of_ball[n];
    const std::size_t to = from - shown->begin + range.begin;
    if (to >= range.end || !same_atom(molecule.atoms[from], molecule.atoms[to])) return nullptr;
    const LatticePoint& p = molecule.atoms[to].position;
    constexpr std::int32_t kMost = kMaxLatticeCoordinate;
    const auto fits = [&](std::int32_t x) { return std::abs(x) <= kMost / factor; };
    if (!fits(p.x) || !fits(p.y) || !fits(p.z)) return nullptr;
    balls->centres[n] = {p.x * factor, p.y * factor, p.z * factor};
  }
  return balls;
}

std::uint64_t key_of_frames(const BallReferences& atoms) {
  const ModelRange* shown = range_of_shown(atoms);
  if (!shown || atoms.molecule().models.size() < 2) return 0;
  std::uint64_t hash = 1;
  for (const char c : atoms.molecule().sha256 + "/" + atoms.molecule().assembly_id) {
    hash = combined(hash, static_cast<unsigned char>(c));
  }
  const PreparedBalls& prepared = atoms.prepared();
  for (std::size_t n = 0; n < prepared.atom_of_ball.size(); ++n) {
    const auto radius = static_cast<std::uint32_t>(prepared.balls->radii[n]);
    hash = combined(hash, (prepared.atom_of_ball[n] - shown->begin) << 32 | radius);
  }
  return combined(hash, static_cast<std::uint64_t>(prepared.balls->lattice.digits) + 1000) | 1;
}

Definition<CurveLinks> curve_links(std::shared_ptr<const CavityCurves> curves, const Key& curve) {
  const auto place = [curves](const Inputs& in) -> double {
    if (curves->axis == CurveAxis::alpha) return in.alpha_angstrom2;
    if (curves->axis == CurveAxis::solvent) return in.solvent_radius_angstrom;
    return static_cast<double>(shown_model(*in.atoms));
  };
  return {{.id = "cavities.curves.links",
           .title = "Cavities on their curves",
           .made_of = {&cavity_table()},
           .key =
               [curve, numbers = curves->numbers](const Inputs& in) {
                 if (!in.atoms) return Key{};
                 Key key = key_of_balls_and_alpha(in);
                 key.more = curve.number() * 4 + (numbers == CurveNumbers::exact ? 3 : 1);
                 return key;
               },
           .memory =
               [curves](const Inputs& in) {
                 const std::uint64_t bytes =
                     curves->samples.size() * in.of(cavity_table()).size() * sizeof(std::uint32_t) +
                     1'000'000;
                 return MemoryNeed{bytes, 2 * bytes};
               },
           .lane = Lane::interactive},
          [curves, place](const Inputs& in, const RunContext& context) {
            return std::make_shared<const CurveLinks>(
                link_curves(*curves, in.of(cavity_table()), place(in), context.cancel));
          }};
}

}  // namespace alphascope
