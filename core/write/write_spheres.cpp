// SPDX-License-Identifier: GPL-3.0-or-later
// Writes filling spheres as a PQR file.
#include "core/write/write_spheres.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/geometry/lattice_alpha.hpp"

namespace alphascope {

void write_spheres_pqr(const std::vector<SphereGroup>& groups,
                       const std::vector<std::pair<std::string, std::string>>& header, int digits,
                       AtomicFile& file) {
  std::string text;
  for (const auto& [key, value] : header) text += "REMARK   3 " + key + " " + value + "\n";
  digits = std::max(digits, 0);
  const double unit = std::pow(10.0, digits);
  std::size_t serial = 0;
  for (const auto& [number, spheres, residue] : groups) {
    for (const FillingSphere& s : spheres) {
      const double radius = std::floor(s.radius_angstrom * unit) / unit;
      const RealPoint& c = s.centre_angstrom;
      char line[200];
      const int size = std::snprintf(
          line, sizeof line, "ATOM  %5zu  SPH %s C %4zu    %8.*f %8.*f %8.*f 0.000 %.*f\n",
          ++serial, residue, number, digits, c.x, digits, c.y, digits, c.z, digits, radius);
      text.append(line, static_cast<std::size_t>(size));
    }
    file.write(text);
    text.clear();
  }
  file.write(text + "END\n");
}

}  // namespace alphascope
