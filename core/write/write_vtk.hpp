// SPDX-License-Identifier: GPL-3.0-or-later
// A complex as VTK's XML files, for ParaView, PyVista and others. VTU is an unstructured grid of
// all simplices. VTP has vertices, edges and triangles as polygonal data.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/complex/alpha_complex.hpp"
#include "core/files/atomic_file.hpp"
#include "core/molecule/molecule.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

struct BallSet;

// The data to write. `balls` are those of which the complex was computed.
struct VtkSource {
  const BallSet& balls;
  const AlphaComplex& complex;
  const Molecule& molecule;
  const std::vector<std::uint32_t>& atom_of_ball;                  // as in PreparedBalls
  const std::vector<std::pair<std::string, std::string>>& header;  // printable
};

// Point i is the centre of ball i (Å, exact). Points have radius_angstrom, ball (their index),
// element (atomic number, 0 unknown), serial, residue_number, atom_name, residue_name and chain.
// Cells have a dimension. Unless there are only tetrahedra, they also have alpha_angstrom2 and
// class (0 singular, 1 regular, 2 interior). The header is the field data.
void write_vtu(const VtkSource& source, AtomicFile& file, const RunContext& context = {});

// Throws std::invalid_argument for a complex of tetrahedra only, because nothing would be left.
void write_vtp(const VtkSource& source, AtomicFile& file, const RunContext& context = {});

// Neither function commits the file. Both throw Cancelled and WriteError, also if cells have more
// corners than these files can count (2^31).

}  // namespace alphascope
