// SPDX-License-Identifier: GPL-3.0-or-later
// The sets of radii from which a user chooses.
#pragma once

#include <cstdint>

namespace alphascope {

// automatic: the file's own radii if it has any; else ProtOr for polymers without hydrogens that
// ProtOr knows; else Bondi.
enum class RadiiSet : std::uint8_t {
  automatic,
  file,
  bondi,
  protor,
  castp,
  alvarez,
  amber,
  naccess,
  rasmol,
  user
};

}  // namespace alphascope
