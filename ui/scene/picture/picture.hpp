// SPDX-License-Identifier: GPL-3.0-or-later
// A complete description of a picture. Saved pictures of the window, the command line and
// recordings use it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/molecule/rgb8.hpp"
#include "ui/scene/mesh/difference_mesh.hpp"
#include "ui/scene/mesh/layer_mesh.hpp"
#include "ui/scene/objects/pictured_object.hpp"
#include "ui/scene/picture/draw_marks.hpp"
#include "ui/scene/scene.hpp"

namespace alphascope {

// Shared data never changes, so any thread may read it.
struct Picture {
  std::shared_ptr<const BallGeometry> balls;
  std::vector<Rgb8> colours;                          // one a ball
  std::vector<float> radii;                           // Å, as drawn; one a ball
  std::shared_ptr<const ComplexMesh> mesh;            // null: none
  std::shared_ptr<const CapMesh> caps;                // null: none
  std::shared_ptr<const DifferenceMesh> differences;  // null: none
  Layers layers;
  std::shared_ptr<const LayerMesh> beside_body;  // null: none
  PicturedObjects objects, layer_objects;
  SceneStyle style;
  std::optional<Viewpoint> viewpoint;  // none: the scene's present view, at first the default view
  MarkedPicture picture;
  PictureTexts texts;
  std::string not_drawn = {};  // a sentence on parts missing for lack of memory; empty: none are
};

// Makes the scene show this picture. Returns the marks, with the labels of the layers.
MarkedPicture show(Scene& scene, const Picture& picture);

}  // namespace alphascope
