// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts between chains, as a derived result: atoms of two chains that share an edge of the
// complex on screen. Such atoms are neighbours whose grown balls meet where no other atom comes
// between.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/document/store/derived.hpp"
#include "core/geometry/ball_index.hpp"

namespace alphascope {

struct ChainContact {
  std::string first, second;  // the chains' names, in the order of the file
  std::size_t edges = 0;      // edges of the complex between them
  // The atoms at these edges, as balls, ascending.
  std::vector<BallIndex> of_first, of_second;
};

struct ChainContacts {
  std::vector<ChainContact> pairs;  // pairs with at least one edge, most edges first
};

// Needs all simplices, not tetrahedra alone, and Inputs::atoms.
const Definition<ChainContacts>& chain_contacts();

}  // namespace alphascope
