// When each cavity is there, for all alphas at once, as bars to draw and as a table. Of voids these
// are the bars of persistent homology in dimension 2; before a void there may be its pocket.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/cavity/cavity_lives.hpp"
#include "core/document/reference/reference.hpp"

namespace alphascope {

// CavityLife in Å²: a pocket from `born` on, a void from `closed` on (where that is before `gone`),
// filled at `gone`. born <= closed.
struct CavityBar {
  std::uint32_t sink = 0;     // its deepest one, a tetrahedron of the triangulation
  double born_angstrom2 = 0;  // may be minus infinity
  double closed_angstrom2 = 0, gone_angstrom2 = 0;

  bool is_ever_void() const { return closed_angstrom2 < gone_angstrom2; }
  bool is_at(double alpha_angstrom2) const {
    return born_angstrom2 <= alpha_angstrom2 && alpha_angstrom2 < gone_angstrom2;
  }
};

struct CavityBars {
  std::vector<CavityBar> longest;  // the longest first
  std::size_t all = 0;             // how many there are
};

// Only what is after `from_angstrom2` counts.
CavityBars longest_bars(const CavityLives& lives, const Lattice& lattice, double from_angstrom2,
                        std::size_t most);

// An alpha at which the cavity is there: the middle of what is after `from_angstrom2`, rounded to
// hundredths where that is still within.
double alpha_within(const CavityBar& bar, double from_angstrom2);

// "a pocket from −0.52 Å², a void from 1.20 Å², filled at 4.85 Å²".
std::string bar_text(const CavityBar& bar);

// Lines of commas: the three alphas (empty: at every smaller one, or never) and the name of each,
// which is the atoms of its deepest sink. `comments` stand above, with "# " before each.
std::string bars_csv(const std::vector<CavityBar>& bars, const Triangulation& triangulation,
                     const BallReferences& references, const std::vector<std::string>& comments);

}  // namespace alphascope
