// SPDX-License-Identifier: GPL-3.0-or-later
// The source of records, with the lattice of their results.
#include "core/document/export/record_source.hpp"

#include "core/geometry/ball_set.hpp"
#include "core/molecule/molecule.hpp"
#include "core/selection/prepare_balls.hpp"
#include "core/selection/provenance.hpp"

namespace alphascope {

Lattice RecordSource::lattice() const {
  return refined.value_or(prepared->balls->lattice);
}

RecordSource RecordSource::on(const Lattice& lattice) const {
  RecordSource source = *this;
  source.refined = lattice;
  return source;
}

Provenance RecordSource::provenance() const {
  Provenance entries = alphascope::provenance(*molecule, options, prepared->report);
  for (auto& [key, value] : entries) {
    if (key == "lattice_unit_angstrom") value = lattice_unit_text(lattice());
  }
  return entries;
}

}  // namespace alphascope
