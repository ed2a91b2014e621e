// SPDX-License-Identifier: GPL-3.0-or-later
// Faces of tetrahedra that several objects share.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

namespace alphascope {

// Codes of faces (face_code.hpp); no object may change them.
struct SharedFaces {
  std::shared_ptr<const void> owner;  // keeps them alive
  std::span<std::uint32_t> faces;
};

}  // namespace alphascope
