// The table of cavities on screen as a text that is written to a file: the same as the command
// line's.
#pragma once

#include "core/document/cavities/cavity_records.hpp"

namespace alphascope {

// Which rows are written: in the order of the table, whatever they are sorted by on screen.
struct CavityRowsWanted {
  bool voids = true, pockets = true;
  std::optional<double> least_volume_sa_angstrom3;
  friend bool operator==(const CavityRowsWanted&, const CavityRowsWanted&) = default;
};

// What other files of them are made of too: the table and `source`, and which rows. No volumes and
// depths.
CavityFacts few_facts_of(const Inputs& in, const CavityRowsWanted& rows,
                         const RecordSource& source);
// Of what is written of them; none where the inputs are of other balls than these.
Key key_of_written(const Inputs& in, const CavityRowsWanted& rows, const PreparedBalls& prepared);

// Not without Inputs::atoms, which are those of `source`.
Definition<std::string> cavities_as_csv(const CavityRowsWanted& rows, const RecordSource& source);
Definition<std::string> cavities_as_json(const CavityRowsWanted& rows, const RecordSource& source);

}  // namespace alphascope
