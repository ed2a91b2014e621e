// SPDX-License-Identifier: GPL-3.0-or-later
// Spheres that fill cavities or channels as a PQR file. Programs for molecules open it as atoms.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/cavity_shape/filling_spheres.hpp"
#include "core/files/atomic_file.hpp"

namespace alphascope {

struct SphereGroup {
  std::size_t number = 1;  // residue number
  std::vector<FillingSphere> spheres;
  const char* residue = "CAV";  // residue name: three letters
};

// Writes atoms SPH in chain C, with a residue for each group. The header is in REMARK lines.
// Coordinates have `digits` digits, those of the lattice, so they are exact. Radii have as many
// digits and are rounded down, so that no sphere cuts into an atom. Does not commit the file.
// Throws WriteError.
void write_spheres_pqr(const std::vector<SphereGroup>& groups,
                       const std::vector<std::pair<std::string, std::string>>& header, int digits,
                       AtomicFile& file);

}  // namespace alphascope
