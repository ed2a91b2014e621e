// SPDX-License-Identifier: GPL-3.0-or-later
// A layer is a panel's drawing in the view, beside balls and complex: simplices, balls, tubes and
// labels. Plain data: panels fill it, the scene draws it. The view leaves out layers for which
// memory is too small, and says so.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/complex/simplices.hpp"
#include "core/geometry/real_point.hpp"
#include "ui/theme.hpp"

namespace alphascope {

struct BallSet;
struct LayerObjects;  // layer_objects.hpp

// Positions are in Å, in the coordinates of the file.
struct LayerSphere {
  RealPoint centre_angstrom;
  double radius_angstrom = 0;
  std::optional<Colour> colour = {};  // none: the layer's
};

// An atom drawn as a lit ball in front of everything else.
struct LayerAtom {
  RealPoint centre_angstrom;
  double radius_angstrom = 0;
  Colour colour;
  std::uint32_t atom = 0;  // index in Molecule::atoms
};

// A few words centred on a point. Nothing hides them. An outline in the background's colour keeps
// them readable.
struct LayerLabel {
  RealPoint at_angstrom;
  std::string text;
};

// Colour of dual objects: power cells, their borders and dual edges.
inline constexpr Colour kDualColour{0.3f, 0.85f, 0.75f, 1};

struct Layer {
  std::string id;                        // includes the panel's name: "signature.appearing"
  std::uint64_t key = 0;                 // changes with the content
  std::shared_ptr<const BallSet> balls;  // balls of the indices below; the layer is drawn only with
                                         // their complex
  Simplices<1> vertices;                 // drawn as small octahedra
  Simplices<2> edges;
  Simplices<3> triangles;
  Simplices<4> tetrahedra;
  // Spheres and tubes are drawn as lit bodies, whatever `body` says. Spheres may for instance fill
  // a cavity. A tube passes through its spheres in order.
  std::vector<LayerSphere> spheres;
  std::vector<std::vector<LayerSphere>> tubes;
  std::string name;  // of bodies, spheres and tubes, shown under the mouse; empty: they have none
  std::string page;  // id of the page that a click on them opens; empty: none
  std::optional<std::size_t> cavity;  // of which they are: its row in the table of cavities
  std::vector<LayerAtom> atoms;
  std::shared_ptr<const LayerObjects> objects;  // null: none
  std::vector<LayerLabel> labels;
  std::vector<std::array<RealPoint, 2>> lines;  // from the first point to the second, over
                                                // everything else; Å
  Colour colour;
  // true: triangles and tetrahedra are bodies with light and shadow, and tetrahedra have darker
  // edges. Edges are then lines, which bodies may hide. false: everything is drawn as marks, over
  // all other things. Vertices are always marks.
  bool body = false;
  // Whether triangles, tetrahedra and spheres of a body have the opacity
  // SceneStyle::cavity_opacity.
  bool translucent = false;
  bool fades_rest = true;   // for bodies: balls and complex become pale, so they hide nothing
  bool in_pictures = true;  // also in pictures that are saved
};

// Largest opacity of balls and complex while a layer fades them.
inline constexpr double kFadedOpacity = 0.15;

using Layers = std::vector<std::shared_ptr<const Layer>>;

}  // namespace alphascope
