// Colours of balls by exposed area: made with the drawing of their complex, so that no picture
// mixes two alphas.
#include <algorithm>

#include "app/viewer/scene_controller.hpp"
#include "core/document/measure_results.hpp"
#include "ui/scene/ball_colours.hpp"

namespace alphascope {
// On the worker's thread.
std::shared_ptr<const SceneController::Exposure> SceneController::make_exposure(
    const DrawnMolecule& molecule, const Answer& answer, ColourBy colour,
    std::shared_ptr<const MeasuredUnion> known, const RunContext& context) {
  auto exposure = std::make_shared<Exposure>();
  exposure->colour = colour;
  exposure->by = known ? std::move(known) : answer.measures;
  if (!exposure->by) {
    exposure->by =
        std::make_shared<const MeasuredUnion>(measure_here(*answer.balls, answer.complex, context));
  }
  exposure->colours = colours_by_exposure(
      {colour, exposure->by->measures, *answer.balls, answer.complex.alpha_on_lattice},
      *molecule.molecule, molecule.prepared->atom_of_ball);
  return exposure;
}

std::vector<Rgb8> SceneController::ball_colours(const DrawnMolecule& molecule, ColourBy colour,
                                                const Exposure* exposure) {
  const std::size_t balls = molecule.geometry->centres.size();
  switch (colour) {
    case ColourBy::element:
      return *molecule.by_element;
    case ColourBy::chain:
      return *molecule.by_chain;
    case ColourBy::exposed:
    case ColourBy::exposed_residue:
      if (exposure && exposure->colour == colour && exposure->colours.size() == balls) {
        return exposure->colours;
      }
      break;
    case ColourBy::single:
    case ColourBy::alpha:
      break;
  }
  return std::vector<Rgb8>(balls, kPlainBall);
}

bool SceneController::is_exposure_shown() const {
  return drawn_exposure_ && drawn_exposure_->colour == display_.ball_colour;
}

std::optional<ColourLegend> SceneController::legend() const {
  if (!display_.balls || !is_exposure_shown()) return alpha_legend_;
  return exposure_legend(display_.ball_colour);
}

std::string SceneController::not_drawn() const {
  const bool lacks = is_exposure(display_.ball_colour) && display_.balls && drawn_answer_ &&
                     !is_exposure_shown() && !draws_nothing();
  if (!lacks) return not_drawn_;
  const std::string why =
      drawn_answer_->complex.tetrahedra_only
          ? "Balls are grey: tetrahedra alone have no exposed area. Switch “Tetrahedra only” off."
          : "Balls are grey until their exposed areas are there.";
  return not_drawn_.empty() ? why : not_drawn_ + " " + why;
}

}  // namespace alphascope
