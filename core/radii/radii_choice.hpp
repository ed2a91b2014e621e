// Which set of radii is asked for.
#pragma once

#include <cstdint>

namespace alphascope {

// automatic = the file's own radii when it has any; else ProtOr when there is polymer without
// hydrogens that ProtOr knows; else Bondi.
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
