// SPDX-License-Identifier: GPL-3.0-or-later
// The definitions of triangulation and filtration, and their way into and out of the store.
#include "core/document/store/derived.hpp"

#include "core/document/store/inputs.hpp"
#include "core/document/store/store.hpp"
#include "core/engine/known_results.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/run/freed_memory.hpp"
#include "core/triangulation/filtration.hpp"
#include "core/triangulation/memory_need.hpp"
#include "core/triangulation/triangulation_maker.hpp"
#include "core/triangulation/triangulation_report.hpp"

namespace alphascope {

const Definition<Triangulation>& whole_triangulation() {
  static const Definition<Triangulation> definition{
      {.id = "triangulation",
       .title = "Triangulation of all balls",
       .key = key_of_balls,
       .memory = [](const Inputs& in) { return triangulation_memory(in.balls->size()); },
       .keep_stale = false},
      [](const Inputs& in, const RunContext& context) {
        constexpr std::size_t kManyBalls = 100'000;
        auto made = std::make_shared<const Triangulation>(make_triangulation_by(
            in.triangulation_maker, *in.balls, in.triangulation_threads, context));
        // CGAL's triangulation took four times as much memory in small pieces, and insertion three
        // times as much.
        if (!made_by_device(*made) && in.balls->size() > kManyBalls) return_freed_memory();
        return made;
      }};
  return definition;
}

const Definition<Filtration>& whole_filtration() {
  static const Definition<Filtration> definition{
      {.id = "filtration",
       .title = "Filtration of all simplices",
       .made_of = {&whole_triangulation()},
       .key = key_of_balls,
       .memory =
           [](const Inputs& in) {
             return filtration_memory(in.of(whole_triangulation()), TetrahedraOfFiltration::shared);
           },
       .keep_stale = false},
      [](const Inputs& in, const RunContext& context) {
        return std::make_shared<const Filtration>(in.balls, in.share(whole_triangulation()),
                                                  context, in.triangulation_maker.get());
      }};
  return definition;
}

ResultsForAllAlphas results_for_all_alphas(const Store& store, const Inputs& inputs) {
  if (!inputs.balls) return {};
  return {inputs.balls, store.have(whole_triangulation(), inputs),
          store.have(whole_filtration(), inputs)};
}

void give_results_for_all_alphas(Store& store, const Inputs& inputs,
                                 const ResultsForAllAlphas& made) {
  store.give(whole_triangulation(), inputs, made.triangulation);
  store.give(whole_filtration(), inputs, made.filtration);
}

}  // namespace alphascope
