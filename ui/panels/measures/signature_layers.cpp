// SPDX-License-Identifier: GPL-3.0-or-later
// Marks in the view the simplices that appear at the present alpha.
#include <memory>

#include "core/complex/alpha_complex.hpp"
#include "core/document/store/derived.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/store.hpp"
#include "core/run/cancel_token.hpp"
#include "core/triangulation/filtration.hpp"
#include "core/triangulation/memory_need.hpp"
#include "ui/layer.hpp"
#include "ui/panels/measures/signature_parts.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

constexpr double kMarkedWithin = 0.02;      // Å², on either side of alpha
constexpr std::size_t kMostMarked = 20000;  // for each dimension; more would be a blur

template <class List, class Simplices>
void collect(const List& list, float low, float high, Simplices& to) {
  for (std::size_t i = 0; i < list.size() && to.size() < kMostMarked; ++i) {
    const float value = list.alpha_values[i];
    if (value >= low && value <= high) to.push_back(list.simplices[i]);
  }
}

std::shared_ptr<const Layer> make_appearing(const Inputs& in, const RunContext& context) {
  const AlphaComplex& all = in.of(whole_filtration()).top();
  auto layer = std::make_shared<Layer>();
  layer->id = "signature.appearing";
  layer->key = key_of_balls_and_alpha(in).number();
  layer->balls = in.balls;
  const auto bound = [&](double alpha) {
    return all.lattice.alpha_on_lattice(alpha).nearest_float();
  };
  const float low = bound(in.alpha_angstrom2 - kMarkedWithin),
              high = bound(in.alpha_angstrom2 + kMarkedWithin);
  collect(all.tetrahedra, low, high, layer->tetrahedra);
  context.cancel.throw_if_cancelled();
  collect(all.triangles, low, high, layer->triangles);
  context.cancel.throw_if_cancelled();
  collect(all.edges, low, high, layer->edges);
  collect(all.vertices, low, high, layer->vertices);
  layer->colour = {1, 0.35f, 0.75f, 1};
  return layer;
}

const Definition<Layer>& appearing() {
  static const Definition<Layer> definition{{.id = "signature.appearing",
                                             .title = "Simplices that appear at this alpha",
                                             .made_of = {&whole_filtration()},
                                             .key = key_of_balls_and_alpha,
                                             .memory =
                                                 [](const Inputs&) {
                                                   constexpr std::uint64_t kMost =
                                                       kMostMarked * 10 * sizeof(BallIndex);
                                                   return MemoryNeed{kMost, kMost};
                                                 },
                                             .lane = Lane::interactive},
                                            make_appearing};
  return definition;
}

}  // namespace

void mark_appearing(PanelContext& ctx, bool& on) {
  checkbox(ctx, "signature.mark", "Mark new simplices", on);
  tooltip(ctx,
          "Marks in the view the simplices whose alpha value is within 0.02 Å² of the present "
          "alpha, at most 20,000 of each dimension.");
  if (!on) return;
  // The layer never belongs to another alpha than the picture.
  const Derived<Layer> layer = ctx.store.want(appearing(), ctx.inputs);
  if (layer.ready()) ctx.state.layers.push_back(layer.value);
}

}  // namespace alphascope
