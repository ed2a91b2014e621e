// SPDX-License-Identifier: GPL-3.0-or-later
// The state of the page of areas and volumes between frames. Plain data.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/document/measures/measure_query.hpp"
#include "core/document/reference/ref_set.hpp"

namespace alphascope {

struct MeasureRows;
struct MeasuredComplex;

struct MeasureState {
  std::string molecule;  // SHA-256 of the molecule's file
  int per = 2;           // index of: components, chains, residues, atoms
  MeasureQuery query;
  bool changes = false;  // derivatives are shown in rows of atoms
  bool copying = false;  // CSV is being made for the clipboard
  // The first atom of each chosen row, since atoms stay while alpha moves.
  std::vector<AtomRef> chosen;
  // The last results. They are grey until the next ones are ready.
  std::shared_ptr<const MeasuredComplex> measured;
  std::shared_ptr<const MeasureRows> rows;
  std::string surface;  // name of the surface that `measured` is of
};

}  // namespace alphascope
