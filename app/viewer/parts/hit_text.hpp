// What the window says of an atom or a simplex under the mouse. Pure functions: no window, no GL.
#pragma once

#include <string>

#include "core/document/reference/reference.hpp"
#include "core/document/settings/request.hpp"
#include "ui/scene/pick/pick.hpp"

namespace alphascope {

struct HitText {
  std::string line;     // for the status bar
  std::string tooltip;  // several lines
};

// `shown`: what the complex on screen was asked for with; null when there is none, and then the
// grown radius is not known.
HitText describe_ball(const BallReferences& references, const Request* shown, BallIndex ball);
// Of an atom of the molecule that the options leave out of the body.
HitText describe_atom_beside(const BallReferences& references, const LeftOutAtom& atom);
HitText describe_simplex(const BallReferences& references, const HitSimplex& simplex);

// "3", "3, 1 not in the picture"; empty for none.
std::string selected_text(std::size_t selected, std::size_t not_in_the_picture);

}  // namespace alphascope
