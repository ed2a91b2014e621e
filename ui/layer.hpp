// Simplices that a panel wants marked in the view, over everything else. Plain data: panels fill
// it, the scene draws it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/complex/simplices.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/real_point.hpp"
#include "ui/theme.hpp"

namespace alphascope {

struct LayerSphere {
  RealPoint centre_angstrom;
  double radius_angstrom = 0;
};

// A few words at a place, always readable.
struct LayerLabel {
  RealPoint at_angstrom;
  std::string text;
};

struct Layer {
  std::string id;                        // of the panel's: "signature.appearing"
  std::uint64_t key = 0;                 // another one for other simplices
  std::shared_ptr<const BallSet> balls;  // that the indices are of; drawn with their complex only
  Simplices<1> vertices;                 // drawn as small octahedra
  Simplices<2> edges;
  Simplices<3> triangles;
  Simplices<4> tetrahedra;
  std::vector<LayerSphere> spheres;             // lit balls, such as those that fill a cavity
  std::vector<std::vector<LayerSphere>> tubes;  // each through its spheres one after the other
  std::vector<LayerLabel> labels;
  Colour colour;
  // Its triangles are a body of their own in the picture, with light and shadow, for which all else
  // fades. False: marks over everything else.
  bool body = false;

  // Meshes of layers are made between two frames, so they are small.
  static constexpr std::size_t kMostSimplices = 20000;
};

using Layers = std::vector<std::shared_ptr<const Layer>>;

}  // namespace alphascope
