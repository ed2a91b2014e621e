// All that a picture is made of, whoever draws it: the window's thread for saved pictures, the
// command line, a recording.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ui/scene/mesh/difference_mesh.hpp"
#include "ui/scene/mesh/layer_mesh.hpp"
#include "ui/scene/picture/draw_marks.hpp"
#include "ui/scene/scene.hpp"

namespace alphascope {

// What is shared never changes.
struct Picture {
  std::shared_ptr<const BallGeometry> balls;
  std::vector<Rgb8> colours;                          // one a ball
  std::vector<float> radii;                           // Å, as drawn; one a ball
  std::shared_ptr<const ComplexMesh> mesh;            // null: none
  std::shared_ptr<const CapMesh> caps;                // null: none
  std::shared_ptr<const DifferenceMesh> differences;  // null: none
  Layers layers;
  std::shared_ptr<const LayerMesh> beside_body;  // null: none
  SceneStyle style;
  std::optional<Viewpoint> viewpoint;  // none: as the scene has it, at first the default view
  MarkedPicture picture;
  PictureTexts texts;
  std::string not_drawn = {};  // what is missing for want of memory; a sentence, or empty
};

// Makes it what the scene shows; returns how it is marked, with the labels of its layers.
MarkedPicture show(Scene& scene, const Picture& picture);

}  // namespace alphascope
