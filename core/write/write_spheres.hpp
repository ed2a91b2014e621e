// Spheres that fill cavities or channels as a PQR file, which programs for molecules open as atoms.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/cavity_shape/filling_spheres.hpp"
#include "core/files/atomic_file.hpp"

namespace alphascope {

struct SphereGroup {
  std::size_t number = 1;  // the residue number
  std::vector<FillingSphere> spheres;
  const char* residue = "CAV";  // its name: three letters
};

// Atoms SPH in chain C, a residue for each group; the header as REMARK lines. Coordinates have
// `digits` digits, those of the lattice, so that they are exact; radii have as many and are rounded
// down, so that no sphere cuts into an atom. Does not commit. Throws WriteError.
void write_spheres_pqr(const std::vector<SphereGroup>& groups,
                       const std::vector<std::pair<std::string, std::string>>& header, int digits,
                       AtomicFile& file);

}  // namespace alphascope
