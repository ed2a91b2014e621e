// What the scene shows, in VTK's arrays. Any thread may make them, which takes a while for a large
// complex; from set_balls(), set_mesh(), set_caps(), set_differences() or set_layers() on they
// belong to the scene alone. The arrays themselves are behind this header: no VTK here.
#pragma once

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

// One colour and one radius (Å, as drawn) a ball, else std::invalid_argument.
std::shared_ptr<BallData> make_ball_data(std::shared_ptr<const BallGeometry> balls,
                                         const std::vector<Rgb8>& colours,
                                         const std::vector<float>& radii);
// Null for null.
std::shared_ptr<MeshData> make_mesh_data(std::shared_ptr<const ComplexMesh> mesh);
std::shared_ptr<CapData> make_cap_data(std::shared_ptr<const CapMesh> mesh);
std::shared_ptr<DifferenceData> make_difference_data(std::shared_ptr<const DifferenceMesh> mesh);
std::shared_ptr<LayerData> make_layer_data(std::shared_ptr<const LayerMesh> mesh);

}  // namespace alphascope
