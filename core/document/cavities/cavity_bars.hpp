// SPDX-License-Identifier: GPL-3.0-or-later
// Bars of cavities for all alphas at once: from birth to filling, for drawing and as a table. A bar
// covers the time as a pocket and the time as a void. The parts as voids are the bars of persistent
// homology in dimension 2.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace alphascope {

class BallReferences;
template <class Row>
struct Column;
struct CavityLives;
struct Lattice;
struct Triangulation;

// A CavityLife in Å²: a pocket from `born` on, a void from `closed` on if closed < gone, filled at
// `gone`. born <= closed.
struct CavityBar {
  std::uint32_t sink = 0;     // the deepest sink, a tetrahedron of the triangulation
  double born_angstrom2 = 0;  // may be minus infinity
  double closed_angstrom2 = 0, gone_angstrom2 = 0;

  bool is_ever_void() const { return closed_angstrom2 < gone_angstrom2; }
  bool is_at(double alpha_angstrom2) const {
    return born_angstrom2 <= alpha_angstrom2 && alpha_angstrom2 < gone_angstrom2;
  }
};

struct CavityBars {
  std::vector<CavityBar> longest;  // longest first
  std::size_t all = 0;             // number of all bars
};

// The `most` longest bars. Lengths count from `from_angstrom2` on.
CavityBars longest_bars(const CavityLives& lives, const Lattice& lattice, double from_angstrom2,
                        std::size_t most);

// An alpha (Å²) at which the cavity exists: the middle of its bar after `from_angstrom2`. It is
// rounded to hundredths if the result is still inside the bar.
double alpha_within(const CavityBar& bar, double from_angstrom2);

// "a pocket from −0.52 Å², a void from 1.20 Å², filled at 4.85 Å²".
std::string bar_text(const CavityBar& bar);

// A row of the table of lives.
struct CavityLifeRow {
  const CavityBar& bar;
  const Triangulation& triangulation;
  const BallReferences& references;
};
std::span<const Column<CavityLifeRow>> life_columns();

// A CSV table: three alphas and a name for each bar. An alpha is empty if it is minus infinity, or
// if the cavity never closes. The name is the atoms of the deepest sink. `comments` come first,
// each after "# ".
std::string bars_csv(const std::vector<CavityBar>& bars, const Triangulation& triangulation,
                     const BallReferences& references, const std::vector<std::string>& comments);

}  // namespace alphascope
