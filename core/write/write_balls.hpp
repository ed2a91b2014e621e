// The balls of a complex as tables, for programs that compute with balls or draw atoms.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/files/atomic_file.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/molecule/molecule.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// Where they come from: keys and values, all printable.
using BallHeader = std::vector<std::pair<std::string, std::string>>;

// "x y z r" in Å, all digits, a line for each ball in the order of the set; the header as lines
// that begin with #. Read again, it is the same set of balls.
void write_xyzr(const BallSet& balls, const BallHeader& header, AtomicFile& file,
                const RunContext& context = {});

// Atoms with their names, all digits and the radii of `balls`; charges are 0, since none are known.
// The header is in REMARK lines. `atom_of_ball` as in PreparedBalls. Lines have the columns of PDB
// files as long as numbers and names fit in there with blanks between, and single blanks beyond. A
// blank in a name is written as "_", since fields of PQR files stand between blanks.
void write_pqr(const BallSet& balls, const Molecule& molecule,
               const std::vector<std::uint32_t>& atom_of_ball, const BallHeader& header,
               AtomicFile& file, const RunContext& context = {});

// None commits. They throw WriteError, and Cancelled.

}  // namespace alphascope
