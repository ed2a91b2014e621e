// SPDX-License-Identifier: GPL-3.0-or-later
// The cavities of the complex on screen, as derived results.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "core/document/cavities/cavity_names.hpp"
#include "core/geometry/ball_index.hpp"

namespace alphascope {

class BallReferences;
struct CavityNumbers;
struct CavityTrace;
template <class T>
struct Definition;
struct CavityGround;
struct CavityLives;
struct CavityTable;
struct ExactCavityMeasures;
struct Inputs;
struct Key;

// Flow and incidences of the whole triangulation. They are made once for a set of balls and do not
// depend on alpha.
const Definition<CavityGround>& cavity_ground();

// The table of cavities of the complex on screen, made anew at each alpha. If
// Inputs::split_networks is true, networks are listed as their parts.
const Definition<CavityTable>& cavity_table();
// Key of results on one cavity of that table: the cavity with this deepest sink (ascending balls).
Key key_of_cavity(const Inputs& in, const std::array<BallIndex, 4>& sink);

// Exact volumes of the table's cavities, computed in the background.
struct ExactVolumes {
  std::vector<ExactCavityMeasures> of;  // of CavityTable::found.cavities
};
const Definition<ExactVolumes>& cavity_volumes();

// The content of a row of the table, without its number.
struct CavityLine {
  bool is_void = false;
  double volume_sa_angstrom3 = 0, area_sa_angstrom2 = 0;
  double volume_ms_angstrom3 = 0, area_ms_angstrom2 = 0;
  double mouth_area_angstrom2 = 0;  // sum over all mouths
  std::size_t mouths = 0;
  LiningCounts lining;
  std::size_t bodies = 0;    // Cavity::bodies
  std::size_t passages = 0;  // for a part of a network
  bool is_network = false, is_part = false;
};
struct CavityLines {
  std::shared_ptr<const CavityTable> table;
  std::shared_ptr<const BallReferences> atoms;
  std::shared_ptr<const CavityNumbers> numbers;  // identify cavities between alphas
  std::shared_ptr<const CavityTrace> trace;      // of this table and those before it
  std::vector<CavityLine> of;                    // by row of the table

  // Whether these lines belong to the present table, so that no new ones need be requested.
  bool is_of(const Inputs& in) const;
  // The same, but the solvent radius may be another.
  bool is_of_but_for_radius(const Inputs& in) const;
  // Whether cavities keep their numbers from those lines to these.
  bool continues(const CavityLines& earlier) const;
};
// Cavities keep the numbers that they have in `before` (core/cavity_identity/cavity_numbers.hpp),
// and the trace goes on (cavity_trace.hpp). Null: both begin anew. Requires Inputs::atoms.
Definition<CavityLines> cavity_lines(const std::shared_ptr<const CavityLines>& before);

// Depths take longer and follow in the background, like exact volumes.
struct CavityDepths {
  std::vector<double> of_angstrom;  // by row of the table; 0 for a void
};
const Definition<CavityDepths>& cavity_depths();

// Births and ends of all cavities, made once for a set of balls.
const Definition<CavityLives>& whole_cavity_lives();

}  // namespace alphascope
