// SPDX-License-Identifier: GPL-3.0-or-later
// Marks selected items and draws labels in the picture. Items that the picture lacks get no mark.
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

  // Sets ViewState::references to the balls on screen.
  void follow_picture();
  std::shared_ptr<const BallReferences> references_of(const Answer& answer) const;
  void mark_selection();
  void draw_annotations();
  void zoom_to(const RefSet& items);  // moves the view until the items fill it
  // Moves the items to the middle of the view, at the same scale.
  void centre_on(const RefSet& items);
  void save_view(const std::string& name);  // replaces a view of the same name
  void go_to_view(const std::string& name);

 private:
  std::optional<std::size_t> place_beside(const Ref& item) const;
  void find_marks();
  SelectedItems drawn_of(const RefSet& items) const;
  bool is_drawn(std::size_t atom) const;  // index of the atom in the molecule

  ViewState& state_;
  SceneController& scene_;
  struct Marked {  // the marked selection, and the inputs of its marks
    RefSet items;
    std::shared_ptr<const BallReferences> references;
    std::shared_ptr<const Answer> answer;
    std::shared_ptr<const LayerMesh> beside;
    Theme theme = Theme::dark;
    SelectedItems drawn;
    std::shared_ptr<const Layer> layer;  // null: no simplex is marked
    std::uint64_t key = 0;
  };
  Marked marked_;
  struct Annotated {  // the drawn labels, and the inputs of their layer
    Annotations annotations;
    std::shared_ptr<const BallReferences> references;
    std::shared_ptr<const BallSet> balls;
    std::shared_ptr<const BallAppearance> looks;
    std::shared_ptr<const LayerMesh> beside;
    Theme theme = Theme::dark;
    std::shared_ptr<const Layer> layer;  // null: nothing is drawn
    std::uint64_t key = 0;
  };
  Annotated annotated_;
};

}  // namespace alphascope
