// SPDX-License-Identifier: GPL-3.0-or-later
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

// The provenance of the balls: keys and values, all printable.
using BallHeader = std::vector<std::pair<std::string, std::string>>;

// Writes "x y z r" in Å with all digits, one line per ball, in the order of the set. The header is
// in lines that begin with #. Reading the file gives the same set of balls.
void write_xyzr(const BallSet& balls, const BallHeader& header, AtomicFile& file,
                const RunContext& context = {});

// Writes atoms with names, all digits, and the radii of `balls`. Charges are 0, because they are
// unknown. The header is in REMARK lines. `atom_of_ball` as in PreparedBalls. Lines have the
// columns of PDB files if all numbers and names fit with blanks between them. Otherwise fields have
// single blanks between them. A blank in a name becomes "_", because blanks separate fields of PQR
// files.
void write_pqr(const BallSet& balls, const Molecule& molecule,
               const std::vector<std::uint32_t>& atom_of_ball, const BallHeader& header,
               AtomicFile& file, const RunContext& context = {});

// Neither function commits the file. Both throw WriteError and Cancelled.

}  // namespace alphascope
