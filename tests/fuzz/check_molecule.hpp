// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the promises of every reader on its molecules. A broken promise ends the program.
#pragma once

#include <cstdlib>
#include <stdexcept>

#include "core/files/read_error.hpp"
#include "core/geometry/alpha.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/molecule/assembly.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/selection/prepare_balls.hpp"
#include "core/text/printable.hpp"

namespace alphascope::fuzz {

inline void require(bool promise) {
  if (!promise) std::abort();
}

inline void check(const Molecule& m) {
  require(!m.atoms.empty() && !m.models.empty());
  std::size_t next = 0;
  for (const ModelRange& model : m.models) {
    require(model.begin == next && model.end > model.begin);
    next = model.end;
  }
  require(next == m.atoms.size());
  const auto inside = [](std::int32_t c) {
    return c >= -kMaxLatticeCoordinate && c <= kMaxLatticeCoordinate;
  };
  for (const Atom& a : m.atoms) {
    require(inside(a.position.x) && inside(a.position.y) && inside(a.position.z));
    require(a.name < m.names.size() && a.residue_name < m.names.size() &&
            a.chain < m.names.size() && a.label_chain < m.names.size());
  }
  require(is_printable(m.title));
  for (NameId id = 0; id < m.names.size(); ++id) require(is_printable(m.text(id)));
  for (const std::string& note : m.notes) require(is_printable(note));
  BallOptions all;
  all.model = kAllModels;
  for (const RadiiSet set : {RadiiSet::automatic, RadiiSet::amber}) {
    all.radii = set;
    const PreparedBalls prepared = prepare_balls(m, all);
    for (const std::int32_t radius : prepared.balls->radii) {
      require(radius > 0 && radius <= kMaxLatticeRadius);
    }
  }
}

// Reads, checks, and expands small molecules. A ReadError must have a reason and a remedy.
template <class Read>
void check_reading(Read read) {
  try {
    const Molecule m = read();
    check(m);
    for (const AssemblyInfo& info : list_assemblies(m)) {
      if (info.atoms > 0 && info.atoms < 10000) check(expand_assembly(m, info.id));
    }
  } catch (const ReadError& error) {
    require(!error.reason().empty() && !error.remedy().empty());
    require(error.reason().size() < 1000 && is_printable(error.what()));
  } catch (const std::invalid_argument&) {
    // The assembly exceeds the lattice.
  }
}

}  // namespace alphascope::fuzz
