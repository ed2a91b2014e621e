// What a panel wants shown in the view beside balls and complex: simplices, balls, tubes and words.
// Plain data: panels fill it, the scene draws it.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/complex/simplices.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/real_point.hpp"
#include "ui/theme.hpp"

namespace alphascope {

// Places are in Å, in the coordinates of the file.
struct LayerSphere {
  RealPoint centre_angstrom;
  double radius_angstrom = 0;
  std::optional<Colour> colour = {};  // none: the layer's
};

// An atom that nothing hides: a lit ball before all else in the picture.
struct LayerAtom {
  RealPoint centre_angstrom;
  double radius_angstrom = 0;
  Colour colour;
  std::uint32_t atom = 0;  // of Molecule::atoms
};

// A few words around a place, always readable: nothing hides them, and an outline in the colour of
// the background keeps them apart from what is behind.
struct LayerLabel {
  RealPoint at_angstrom;
  std::string text;
};

// Of what is dual: cells, their borders and edges.
inline constexpr Colour kDualColour{0.3f, 0.85f, 0.75f, 1};

struct Layer {
  std::string id;                        // of the panel's: "signature.appearing"
  std::uint64_t key = 0;                 // another one for another content
  std::shared_ptr<const BallSet> balls;  // that the indices are of; drawn with their complex only
  Simplices<1> vertices;                 // drawn as small octahedra
  Simplices<2> edges;
  Simplices<3> triangles;
  Simplices<4> tetrahedra;
  // Always bodies: lit balls, such as those that fill a cavity, and tubes, each through its spheres
  // one after the other.
  std::vector<LayerSphere> spheres;
  std::vector<std::vector<LayerSphere>> tubes;
  std::vector<LayerAtom> atoms;
  std::vector<LayerLabel> labels;
  std::vector<std::array<RealPoint, 2>> lines;  // from here to there, over everything else; Å
  Colour colour;
  // Its triangles and tetrahedra are bodies in the picture, with light and shadow, and tetrahedra
  // with darker edges; its edges are lines on bodies, which may hide them. False: marks over
  // everything else. Vertices always are such marks.
  bool body = false;
  // Of a body: triangles, tetrahedra and spheres are as opaque as SceneStyle::cavity_opacity.
  bool translucent = false;
  bool fades_rest = true;   // of a body: balls and complex become pale, so that they hide nothing
  bool in_pictures = true;  // also in pictures that are saved

  // A panel gives no more of a kind. What there is no memory for the view leaves out and says so.
  static constexpr std::size_t kMostSimplices = 4000000;
};

// What fades is at most as opaque as this.
inline constexpr double kFadedOpacity = 0.15;

using Layers = std::vector<std::shared_ptr<const Layer>>;

}  // namespace alphascope
