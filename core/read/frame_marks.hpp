// Frames of a file without MODEL records: the same atoms again, in the same order, behind each END
// or TER, as VMD and others write trajectories.
#pragma once

#include <cstddef>
#include <vector>

#include "core/molecule/molecule.hpp"

namespace alphascope {

class FrameMarks {
 public:
  // `atoms` have been read where the record stands.
  void end_record(std::size_t atoms) { mark(ends_, atoms); }
  void ter_record(std::size_t atoms) { mark(ters_, atoms); }

  // Makes models of the frames and says so; a molecule that has models is left as it is. Behind an
  // END the file begins anew, so names are enough. Behind a TER goes on what may as well be another
  // copy of the chain, so there the atoms' serial numbers must be the same as well.
  void split(Molecule& molecule) const;

 private:
  static void mark(std::vector<std::size_t>& marks, std::size_t atoms) {
    if (atoms > 0 && (marks.empty() || marks.back() != atoms)) marks.push_back(atoms);
  }
  std::vector<std::size_t> ends_, ters_;
};

}  // namespace alphascope
