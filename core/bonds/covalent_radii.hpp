// SPDX-License-Identifier: GPL-3.0-or-later
// Covalent radii of the elements: B. Cordero et al., Dalton Trans. 2008, 2832-2838.
#pragma once

#include "core/molecule/element.hpp"

namespace alphascope {

// Å. Carbon is that of four bonds; Mn, Fe and Co have low spin. 0 for an unknown element, and
// beyond curium.
double covalent_radius_angstrom(Element element);

// How many covalent bonds an element has at most. 0 for noble gases.
int most_bonds(Element element);

}  // namespace alphascope
