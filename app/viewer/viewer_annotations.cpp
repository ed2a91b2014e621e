// Labels, distances, angles and marks in the picture on screen.
#include <algorithm>

#include "app/viewer/viewer.hpp"
#include "ui/annotation_layer.hpp"

namespace alphascope {

// As a ball that is not hidden, or beside the body.
bool Viewer::is_drawn(std::size_t atom) const {
  const std::vector<std::uint32_t>& atoms = state_.references->prepared().atom_of_ball;
  const auto at = std::lower_bound(atoms.begin(), atoms.end(), atom);
  if (at != atoms.end() && *at == atom) {
    const auto& looks = annotated_.looks;
    return !looks || !looks->hides(static_cast<BallIndex>(at - atoms.begin()));
  }
  const std::vector<LeftOutAtom>& beside = scene_.beside_body().atoms;
  const auto left =
      std::lower_bound(beside.begin(), beside.end(), atom,
                       [](const LeftOutAtom& a, std::size_t i) { return a.atom < i; });
  return left != beside.end() && left->atom == atom;
}

void Viewer::draw_annotations() {
  follow_picture();
  const auto& answer = scene_.drawn_answer();
  const std::shared_ptr<const BallSet> balls = answer ? answer->balls : nullptr;
  Annotated& a = annotated_;
  const bool same = a.annotations == state_.settings.annotations &&
                    a.references == state_.references && a.balls == balls &&
                    a.looks == scene_.drawn_looks() && a.beside == scene_.beside_body().mesh &&
                    a.theme == state_.window.theme;
  if (!same) {
    a = {state_.settings.annotations, state_.references,   balls,   scene_.drawn_looks(),
         scene_.beside_body().mesh,   state_.window.theme, nullptr, a.key + 1};
    if (a.references && a.balls) {
      a.layer =
          make_annotation_layer(a.annotations, {*a.references, a.balls,
                                                [this](std::size_t atom) { return is_drawn(atom); },
                                                palette(a.theme).warning, a.key});
    }
  }
  if (a.layer) state_.layers.push_back(a.layer);
}

}  // namespace alphascope
