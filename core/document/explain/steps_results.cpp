// SPDX-License-Identifier: GPL-3.0-or-later
// Definitions of steps, the reading of a selection, and sentences on the effect of optimisations.
#include "core/document/explain/steps_results.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "core/document/explain/saturation_text.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/store/definition.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/key.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/run/internal_error.hpp"
#include "core/text/as_sentence.hpp"
#include "core/text/grouped_number.hpp"
#include "core/triangulation/memory_need.hpp"

namespace alphascope {
namespace {

BallSteps dual_edge_steps_of(const BallSet& balls, BallIndex ball,
                             const LatticeAlpha& alpha_on_lattice, const TupleOptions&,
                             const RunContext& context) {
  return dual_edge_steps(balls, ball, alpha_on_lattice, context);
}

constexpr StepsEngineSpec kEngines[] = {
    {StepsEngine::tuples, "Tuple engine (thesis)", true, tuple_steps},
    {StepsEngine::dual_edges, "Dual-edge engine", false, dual_edge_steps_of}};

// Memory for a grid of all balls, in two runs one after the other. The lists of a ball are bounded.
MemoryNeed steps_memory(const Inputs& in) {
  return {4'000'000, 60'000'000 + 120 * in.balls->size()};
}

std::uint64_t with_bits(std::uint64_t number, const StepsRequest& asked) {
  const TupleOptions& o = asked.options;
  return number * 64 + static_cast<std::uint64_t>(asked.engine) * 8 +
         (o.grid == TupleGridKind::thesis ? 4u : 0u) + (o.edge_optimisation ? 2u : 0u) +
         (o.alpha_optimisation ? 1u : 0u);
}

// Compares a number of 4-tuples (`now`) with that of a run with all optimisations (`before`).
std::string growth_of(const std::string& now, const std::string& before) {
  return now == before ? "the same " + now : now + " instead of " + before;
}

// Number of 4-tuples in kernel I after the edge optimisation; empty if the steps end before.
std::string made_text(const BallSteps& steps) {
  if (steps.find(StepKind::too_many)) return "more than " + grouped(kMostTuplesOfBall);
  const Step* tuples = steps.find(StepKind::tuples);
  return tuples ? grouped(tuples->count(step_count::kKept).all) : "";
}
std::string tested_text(const BallSteps& steps) {
  const Step* filter = steps.find(StepKind::filter);
  return filter ? grouped(filter->count(step_count::kTested).all) : "";
}

std::string growth_text(const BallSteps& now, const BallSteps& optimised) {
  const std::string made = made_text(now), made_before = made_text(optimised);
  if (made.empty() || made_before.empty()) return {};
  if (optimised.find(StepKind::too_many))
    return {};  // the steps ended before, so nothing was
                // counted
  std::string text = growth_of(made, made_before) + " 4-tuples in kernel I";
  const std::string tested = tested_text(now), tested_before = tested_text(optimised);
  if (!tested.empty() && !tested_before.empty()) {
    text += ", " + growth_of(tested, tested_before) + " in kernel II";
  }
  return as_sentence(text);
}

}  // namespace

std::span<const StepsEngineSpec> steps_engines() {
  return kEngines;
}

const StepsEngineSpec& spec_of(StepsEngine engine) {
  for (const StepsEngineSpec& spec : kEngines) {
    if (spec.engine == engine) return spec;
  }
  throw InternalError("There are no steps of this engine.");
}

SelectedBall selected_ball(const Selection& selection, const BallReferences& atoms) {
  if (selection.items.empty()) {
    return {{},
            "Click an atom in the picture to see, step by step, how the engine finds its "
            "simplices. For an edge, triangle or tetrahedron, the first atom counts."};
  }
  std::vector<Ref> items;
  for (const AtomRef& atom : selection.atoms_in_order()) items.push_back(atom);
  if (items.empty()) items = selection.items.items();
  for (const Ref& item : items) {
    const auto* atom = std::get_if<AtomRef>(&item);
    const auto ball = atoms.ball(atom ? *atom : std::get<SimplexRef>(item).front());
    if (ball) return {ball, {}};
  }
  return {{}, "The selection has no ball: the choice of atoms at the left leaves it out."};
}

std::optional<BallIndex> middle_ball(const BallSet& balls) {
  std::array<double, 3> mean{};
  const auto place = [](const LatticePoint& p) {
    return std::array{static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
  };
  for (const LatticePoint& centre : balls.centres) {
    const auto p = place(centre);
    for (int k = 0; k < 3; ++k) mean[k] += p[k] / static_cast<double>(balls.size());
  }
  std::optional<BallIndex> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const auto p = place(balls.centres[i]);
    double square = 0;
    for (int k = 0; k < 3; ++k) square += (p[k] - mean[k]) * (p[k] - mean[k]);
    if (square >= least) continue;
    least = square;
    nearest = static_cast<BallIndex>(i);
  }
  return nearest;
}

const StepCount* ExplainedSteps::optimised_count(const Step& step, std::string_view id) const {
  const Step* same = optimised ? optimised->find(step.kind) : nullptr;
  if (same == nullptr) return nullptr;
  const auto at = std::find_if(same->counts.begin(), same->counts.end(),
                               [&](const StepCount& count) { return count.id == id; });
  return at == same->counts.end() ? nullptr : &*at;
}

Definition<ExplainedSteps> explained_steps(const StepsRequest& asked) {
  return {{.id = kStepsId,
           .title = "Steps of a ball",
           .key =
               [asked](const Inputs& in) {
                 if (!in.atoms || asked.ball >= in.balls->size()) return Key{};
                 Key key = key_of_balls_and_alpha(in);
                 key.more = with_bits(std::uint64_t{asked.ball} + 1, asked);
                 return key;
               },
           .memory = steps_memory,
           .lane = Lane::interactive},
          [asked](const Inputs& in, const RunContext& context) {
            auto told = std::make_shared<ExplainedSteps>();
            const StepsEngineSpec& spec = spec_of(asked.engine);
            const LatticeAlpha alpha = in.balls->lattice.alpha_on_lattice(in.alpha_angstrom2);
            const auto make = [&](const TupleOptions& options) {
              return spec.make(*in.balls, asked.ball, alpha, options, context);
            };
            told->steps = make(asked.options);
            TupleOptions all_on = asked.options;
            all_on.edge_optimisation = all_on.alpha_optimisation = true;
            if (spec.has_optimisations && all_on != asked.options) {
              told->optimised = make(all_on);
              told->growth = growth_text(told->steps, *told->optimised);
            }
            const BallName name = [&](BallIndex ball) { return atom_text(*in.atoms, ball); };
            for (const Step& step : told->steps.steps) {
              told->texts.push_back(step_text(told->steps, step, name));
            }
            told->saturation = ball_saturation(*in.balls, asked.ball, context);
            told->saturation_text = saturation_text(told->saturation);
            return std::shared_ptr<const ExplainedSteps>(std::move(told));
          }};
}

}  // namespace alphascope
