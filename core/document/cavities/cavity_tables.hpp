// SPDX-License-Identifier: GPL-3.0-or-later
// The table of cavities on screen as CSV or JSON text, equal to that of the command line.
#pragma once

#include "core/document/cavities/cavity_records.hpp"

namespace alphascope {

template <class T>
struct Definition;
struct Inputs;
struct Key;

// Filter for rows. They are written in the order of the table, however they are sorted on screen.
struct CavityRowsWanted {
  bool voids = true, pockets = true;
  std::optional<double> least_volume_sa_angstrom3;
  friend bool operator==(const CavityRowsWanted&, const CavityRowsWanted&) = default;
};

// Facts that other files need too: the table, `source` and the selected rows, without volumes and
// depths.
CavityFacts facts_without_volumes(const Inputs& in, const CavityRowsWanted& rows,
                                  const RecordSource& source);
// Key of the written text. Empty if the inputs belong to other balls than `prepared`.
Key key_of_cavity_file(const Inputs& in, const CavityRowsWanted& rows,
                       const PreparedBalls& prepared);

// Both require Inputs::atoms, which must be those of `source`.
Definition<std::string> cavities_as_csv(const CavityRowsWanted& rows, const RecordSource& source);
Definition<std::string> cavities_as_json(const CavityRowsWanted& rows, const RecordSource& source);

}  // namespace alphascope
