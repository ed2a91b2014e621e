// The cavities of what is on screen, as derived results.
#pragma once

#include "core/cavity/cavity_numbers.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/document/derived.hpp"

namespace alphascope {

// Flow and incidences of the whole triangulation: once for a set of balls, whatever alpha is.
const Definition<CavityGround>& cavity_ground();

// The table of the complex on screen; made anew at each alpha.
const Definition<CavityTable>& cavity_table();

// Numbers of its cavities that go on from those of the table before, null: there is none. While
// `before` is of the very table that is wanted, it is the answer, and there is nothing to ask for.
Definition<CavityNumbers> cavity_numbers(std::shared_ptr<const CavityNumbers> before);

// Exact volumes of its cavities, which follow in the background.
struct ExactVolumes {
  std::vector<ClippedMeasures> of;  // CavityTable::found.cavities
};
const Definition<ExactVolumes>& cavity_volumes();

}  // namespace alphascope
