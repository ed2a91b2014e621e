// SPDX-License-Identifier: GPL-3.0-or-later
// Contents of the scene in VTK's arrays. For a large complex they take long to make, so any thread
// may make them. Once handed to the scene, by set_mesh() for instance, only the scene may use them.
// This header needs no VTK.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "ui/scene/mesh/ball_geometry.hpp"
#include "ui/scene/mesh/cap_mesh.hpp"
#include "ui/scene/mesh/complex_mesh.hpp"
#include "ui/scene/mesh/difference_mesh.hpp"
#include "ui/scene/mesh/layer_mesh.hpp"

namespace alphascope {

struct BallData;
struct MeshData;
struct DifferenceData;
struct CapData;
struct LayerData;
struct ObjectData;
struct ObjectMesh;

// Each ball needs one colour and one radius (Å, as drawn); otherwise throws std::invalid_argument.
std::shared_ptr<BallData> make_ball_data(std::shared_ptr<const BallGeometry> balls,
                                         const std::vector<Rgb8>& colours,
                                         const std::vector<float>& radii);
// These functions return null for null.
std::shared_ptr<MeshData> make_mesh_data(std::shared_ptr<const ComplexMesh> mesh);
std::shared_ptr<CapData> make_cap_data(std::shared_ptr<const CapMesh> mesh);
std::shared_ptr<DifferenceData> make_difference_data(std::shared_ptr<const DifferenceMesh> mesh);
std::shared_ptr<LayerData> make_layer_data(std::shared_ptr<const LayerMesh> mesh);
std::shared_ptr<ObjectData> make_object_data(std::shared_ptr<const ObjectMesh> mesh);

// Whose objects: those of the settings fade while a layer fades the rest; those of layers do not.
enum class ObjectGroup : std::uint8_t { settings, layers };

// An object of the molecule's atoms in the scene.
struct SceneObject {
  std::shared_ptr<ObjectData> data;
  float opacity = 1;      // above 0, at most 1
  bool in_front = false;  // its sticks are drawn in front of everything else
};

}  // namespace alphascope
