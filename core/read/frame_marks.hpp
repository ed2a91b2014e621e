// SPDX-License-Identifier: GPL-3.0-or-later
// Frames of a file without MODEL records. VMD and others write trajectories so: the same atoms in
// the same order again behind each END or TER.
#pragma once

#include <cstddef>
#include <vector>

#include "core/molecule/molecule.hpp"

namespace alphascope {

class FrameMarks {
 public:
  // `atoms`: how many atoms were read before the record.
  void end_record(std::size_t atoms) { mark(ends_, atoms); }
  void ter_record(std::size_t atoms) { mark(ters_, atoms); }

  // Makes models of the frames and adds a note. A molecule with models is unchanged. Behind END the
  // same names suffice, because the file begins anew there. Behind TER another copy of the chain
  // may follow, so serial numbers must repeat as well.
  void split(Molecule& molecule) const;

 private:
  static void mark(std::vector<std::size_t>& marks, std::size_t atoms) {
    if (atoms > 0 && (marks.empty() || marks.back() != atoms)) marks.push_back(atoms);
  }
  std::vector<std::size_t> ends_, ters_;
};

}  // namespace alphascope
