// Marks and labels on the picture, and what of a selection it shows.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "app/viewer/scene/scene_controller.hpp"
#include "core/document/reference/reference.hpp"
#include "ui/panels/view_state.hpp"

namespace alphascope {

class ShownMarks {
 public:
  ShownMarks(ViewState& state, SceneController& scene) : state_(state), scene_(scene) {}

  // ViewState::references become those of the balls on screen.
  void follow_picture();
  std::shared_ptr<const BallReferences> references_of(const Answer& answer) const;
  void mark_selection();
  void draw_annotations();
  void zoom_to(const RefSet& items);        // they fill the view
  void centre_on(const RefSet& items);      // they become its middle, at the same size
  void save_view(const std::string& name);  // in place of one of that name
  void go_to_view(const std::string& name);

 private:
  std::optional<std::size_t> place_beside(const Ref& item) const;
  void find_marks();
  SceneController::Selected drawn_of(const RefSet& items) const;
  bool is_drawn(std::size_t atom) const;  // of the molecule, by index

  ViewState& state_;
  SceneController& scene_;
  struct Marked {  // the selection that is marked, and what the marks were made of
    RefSet items;
    std::shared_ptr<const BallReferences> references;
    std::shared_ptr<const Answer> answer;
    std::shared_ptr<const LayerMesh> beside;
    Theme theme = Theme::dark;
    SceneController::Selected drawn;
    std::shared_ptr<const Layer> layer;  // null: no simplex
    std::uint64_t key = 0;
  };
  Marked marked_;
  struct Annotated {  // labels that are drawn, and what their layer was made of
    Annotations annotations;
    std::shared_ptr<const BallReferences> references;
    std::shared_ptr<const BallSet> balls;
    std::shared_ptr<const BallAppearance> looks;
    std::shared_ptr<const LayerMesh> beside;
    Theme theme = Theme::dark;
    std::shared_ptr<const Layer> layer;  // null: nothing
    std::uint64_t key = 0;
  };
  Annotated annotated_;
};

}  // namespace alphascope
