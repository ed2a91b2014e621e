// The cavities of what is on screen, as derived results.
#pragma once

#include <array>
#include "core/cavity/cavity_lives.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/cavity_identity/cavity_numbers.hpp"
#include "core/document/cavities/cavity_names.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/store/derived.hpp"

namespace alphascope {

// Flow and incidences of the whole triangulation: once for a set of balls, whatever alpha is.
const Definition<CavityGround>& cavity_ground();

// The table of the complex on screen; made anew at each alpha. Networks are listed as their parts
// where Inputs::split_networks says so.
const Definition<CavityTable>& cavity_table();
// Of what is asked of one cavity of that table: the one with this deepest sink (ascending balls).
Key key_of_cavity(const Inputs& in, const std::array<BallIndex, 4>& sink);

// Exact volumes of its cavities, which follow in the background.
struct ExactVolumes {
  std::vector<ClippedMeasures> of;  // CavityTable::found.cavities
};
const Definition<ExactVolumes>& cavity_volumes();

// What a row of the table shows beside its number.
struct CavityLine {
  bool is_void = false;
  double volume_sa_angstrom3 = 0, area_sa_angstrom2 = 0;
  double volume_ms_angstrom3 = 0, area_ms_angstrom2 = 0;
  double mouth_area_angstrom2 = 0;  // of all mouths
  std::size_t mouths = 0;
  LiningCounts lining;
  std::size_t bodies = 0;    // Cavity::bodies
  std::size_t passages = 0;  // of a part of a network
  bool is_network = false, is_part = false;
};
struct CavityLines {
  std::shared_ptr<const CavityTable> table;
  std::shared_ptr<const BallReferences> atoms;
  std::shared_ptr<const CavityNumbers> numbers;  // which cavity is which
  std::vector<CavityLine> of;                    // rows of the table

  // Of what is on screen: then there is nothing to ask for.
  bool is_of(const Inputs& in) const {
    return table->ground->balls == in.balls &&
           table->question.alpha_angstrom2 == in.alpha_angstrom2 &&
           table->question.split_networks == in.split_networks;
  }
};
// Its numbers go on from `before`, null: there are none. Not without Inputs::atoms.
Definition<CavityLines> cavity_lines(std::shared_ptr<const CavityNumbers> before);

// What of a line takes longer, and follows in the background as exact volumes do.
struct CavityDepths {
  std::vector<double> of_angstrom;  // rows of the table; 0 of a void
};
CavityDepths make_cavity_depths(const CavityTable& table, const RunContext& context = {});
const Definition<CavityDepths>& cavity_depths();

// From which alpha to which each cavity is there: once for a set of balls.
const Definition<CavityLives>& whole_cavity_lives();

}  // namespace alphascope
