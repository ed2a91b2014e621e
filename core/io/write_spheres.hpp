// Spheres that fill cavities as a PQR file, which programs for molecules open as atoms.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/cavity/filling_spheres.hpp"
#include "core/io/atomic_file.hpp"

namespace alphascope {

struct CavitySpheres {
  std::size_t number = 1;  // the residue number
  std::vector<FillingSphere> spheres;
};

// Atoms SPH of residues CAV in chain C; the header as REMARK lines. Coordinates have `digits`
// digits, those of the lattice, so that they are exact; radii have as many and are rounded down, so
// that no sphere cuts into an atom. Does not commit. Throws WriteError.
void write_spheres_pqr(const std::vector<CavitySpheres>& cavities,
                       const std::vector<std::pair<std::string, std::string>>& header, int digits,
                       AtomicFile& file);

}  // namespace alphascope
