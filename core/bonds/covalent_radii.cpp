// SPDX-License-Identifier: GPL-3.0-or-later
// The table of covalent radii.
#include "core/bonds/covalent_radii.hpp"

#include <iterator>

namespace alphascope {
namespace {

// Picometres, by atomic number.
constexpr unsigned char kPicometres[] = {
    0,                                            //
    31,  28,                                      // H, He
    128, 96,  84,  76,  71,  66,  57,  58,        // Li to Ne
    166, 141, 121, 111, 107, 105, 102, 106,       // Na to Ar
    203, 176, 170, 160, 153, 139, 139, 132, 126,  // K to Co
    124, 132, 122, 122, 120, 119, 120, 120, 116,  // Ni to Kr
    220, 195, 190, 175, 164, 154, 147, 146, 142,  // Rb to Rh
    139, 145, 144, 142, 139, 139, 138, 139, 140,  // Pd to Xe
    244, 215, 207, 204, 203, 201, 199, 198, 198, 196, 194, 192, 192, 189, 190, 187, 187,  // to Lu
    175, 170, 162, 151, 144, 141, 136, 136, 132, 145, 146, 148, 140, 150, 150,  // Hf to Rn
    255, 221, 215, 206, 200, 196, 190, 187, 180, 169                            // Fr to Cm
};
constexpr int kFrancium = 87;

}  // namespace

double covalent_radius_angstrom(Element element) {
  if (element >= std::size(kPicometres)) return 0;
  if (element == kFrancium) return 2.60;  // beyond a byte
  return kPicometres[element] / 100.0;
}

int most_bonds(Element element) {
  switch (element) {
    case 1:  // H
    case 9:  // F
      return 1;
    case 2:  // the noble gases
    case 10:
    case 18:
    case 36:
    case 54:
    case 86:
      return 0;
    case 8:  // O, in an oxonium
      return 3;
    case 5:   // B
    case 6:   // C
    case 7:   // N, in an ammonium
    case 17:  // Cl, in a perchlorate
    case 35:  // Br
      return 4;
    default:
      return 6;
  }
}

}  // namespace alphascope
