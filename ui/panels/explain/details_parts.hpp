// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of the page “Details”, for its own sources only.
#pragma once

#include <cstddef>
#include <string>

namespace alphascope {

class BallReferences;
struct PanelContext;
struct SimplexDetails;

// Draws facts on this atom of the molecule, which may be no ball.
void draw_atom_facts(PanelContext& ctx, const BallReferences& atoms, std::size_t atom);
void draw_simplex_facts(PanelContext& ctx, const SimplexDetails& details);
// Returns a text such as "5 edges", for simplices with this many corners.
std::string simplices_counted(std::size_t n, std::size_t corners);

// Draws the vertices of the simplex, and the atoms and simplices around it. A click on a line
// selects the thing.
void draw_simplices_around(PanelContext& ctx, const BallReferences& atoms,
                           const SimplexDetails& details);

}  // namespace alphascope
