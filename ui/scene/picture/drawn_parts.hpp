// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the parts of a picture from balls, complex and settings, and a picture of the parts. The
// window, saved pictures, recordings, sessions and the command line all use these functions. Pure
// C++, may run in a worker; no VTK.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/document/picture/picture_options.hpp"
#include "core/document/reference/appearance.hpp"
#include "core/document/settings/clip.hpp"
#include "core/document/settings/display.hpp"
#include "ui/scene/mesh/cap_mesh.hpp"
#include "ui/scene/mesh/complex_mesh.hpp"
#include "ui/scene/mesh/difference_mesh.hpp"
#include "ui/scene/picture/painting.hpp"
#include "ui/scene/picture/picture.hpp"

namespace alphascope {

// One colour for each ball.
using ColoursOfBalls = std::shared_ptr<const std::vector<Rgb8>>;

// build_mesh(), or a function in its place.
using MeshMaker = std::function<ComplexMesh(
    const BallGeometry& balls, const std::vector<Rgb8>& colours, const AlphaComplex& complex,
    const MeshOptions& options, const CancelToken& cancel)>;

// Hidden balls and chosen colours for each ball; null if there are none.
std::shared_ptr<const BallAppearance> make_ball_appearance(const PicturedMolecule& molecule,
                                                           const Appearance& appearance);

struct Paintings {
  std::shared_ptr<const Painting> balls;      // null: no ball is drawn
  std::shared_ptr<const Painting> simplices;  // null unless simplices have colours of balls
};

struct PartsTask {
  std::shared_ptr<const PicturedMolecule> molecule;
  std::shared_ptr<const EngineAnswer> answer;  // null: there is no complex
  DisplaySettings display;
  std::shared_ptr<const BallAppearance> looks;  // null: as made by the display controls
  MeshOptions mesh;                             // of the controls, less what memory does not allow
  Clip clip;
  bool with_radii = true;  // false: those of the picture before stay
};

struct DrawnParts {
  std::shared_ptr<const BallAppearance> looks;  // for balls and simplices; may be null
  Paintings paintings;
  // The display settings of the radii.
  float ball_scale = 0;
  bool grown_balls = false;
  std::vector<float> radii;                 // Å, as drawn; one a ball. Empty: see PartsTask
  std::shared_ptr<const ComplexMesh> mesh;  // null: none
  MeshOptions options;                      // of mesh
  double mesh_milliseconds = 0;             // for mesh and colours
  ColoursOfBalls simplex_colours;           // of mesh
  Clip clip;
  std::shared_ptr<const CapMesh> caps;                // null: the clip cuts nothing that has caps
  std::shared_ptr<const DifferenceMesh> differences;  // null: none; make_parts() makes none

  // The colours of the balls, chosen colours included. `balls` is their number.
  std::vector<Rgb8> ball_colours(std::size_t balls) const;
  // The meaning of the colours of simplices; none: they have no meaning.
  std::optional<ColourMeaning> simplex_key() const;
  // Sentences on colours that have no values, each once. `with_balls`: balls are drawn.
  std::vector<std::string> missing_colours(bool with_balls) const;
};

// `earlier` are paintings of an earlier picture, which are used again if they fit. Throws as
// make_painting() and `make_mesh` do, and Cancelled.
DrawnParts make_parts(const PartsTask& task, const Paintings& earlier, const MeshMaker& make_mesh,
                      const RunContext& context);

// Sets the radii, and the settings that they come from, in `parts`, which need looks. `answer` may
// be null; no ball is grown then.
void set_radii(DrawnParts& parts, const PicturedMolecule& molecule, const EngineAnswer* answer,
               const DisplaySettings& display);

// The caps of a mesh at another clip. `parts` need looks, mesh, options and colours of simplices.
// Null if the clip cuts nothing that has caps.
std::shared_ptr<const CapMesh> make_caps(const PicturedMolecule& molecule,
                                         const EngineAnswer* answer, const DrawnParts& parts,
                                         const Clip& clip, const CancelToken& cancel);

// View and contents of a picture beside its parts.
struct PictureFrame {
  SceneStyle style;                    // with the cut of the parts
  std::optional<Viewpoint> viewpoint;  // none: the default view
  PictureOptions options;
  Layers layers;
  std::shared_ptr<const LayerMesh> beside_body;  // null: none
  PicturedObjects objects, layer_objects;
  PictureTexts texts;     // on the source of the complex
  std::string not_drawn;  // a sentence on parts missing for lack of memory; empty: none are
};

// The picture of these parts. Its texts also name hidden atoms, missing colours and missing parts.
// `answer` may be null.
Picture picture_of(const PicturedMolecule& molecule, const EngineAnswer* answer,
                   const DrawnParts& parts, PictureFrame frame);

// Adds a text on hidden atoms, and one that names everything the picture lacks. `not_drawn` as in
// Picture.
void note_missing(PictureTexts& texts, const DrawnParts& parts, bool with_balls,
                  const std::string& not_drawn);

// `text` with those sentences that it does not contain yet.
std::string with_sentences(std::string text, const std::vector<std::string>& sentences);

}  // namespace alphascope
