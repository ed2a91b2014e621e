// SPDX-License-Identifier: GPL-3.0-or-later
// Describes the atom or simplex under the mouse in words. Pure functions: no window, no GL.
#pragma once

#include <string>

#include "core/document/reference/reference.hpp"
#include "core/document/settings/request.hpp"
#include "ui/scene/pick/pick.hpp"

namespace alphascope {

struct LeftOutAtom;

struct HitText {
  std::string line;     // for the status bar
  std::string tooltip;  // several lines
};

// `shown`: the request of the complex on screen. Null if there is no complex; the grown radius is
// then left out.
HitText describe_ball(const BallReferences& references, const Request* shown, BallIndex ball);
// Describes an atom that the molecule's options leave out of the body.
HitText describe_atom_beside(const BallReferences& references, const LeftOutAtom& atom);
HitText describe_simplex(const BallReferences& references, const HitSimplex& simplex);

// "3" or "3, 1 not in the picture"; empty if nothing is selected.
std::string selected_text(std::size_t selected, std::size_t not_in_the_picture);

}  // namespace alphascope
