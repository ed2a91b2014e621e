// SPDX-License-Identifier: GPL-3.0-or-later
// Finds on the device the same faces as core/triangulation/outer_faces.hpp on the CPU. Plain C++.
#pragma once

#include <memory>
#include <optional>

#include "core/complex/face_code.hpp"
#include "core/complex/shared_faces.hpp"
#include "gpu/memory/device_complex.hpp"

namespace alphascope::gpu {

class OuterFaceFinder {
 public:
  OuterFaceFinder();  // throws DeviceError
  ~OuterFaceFinder();

  // The faces that belong to only one tetrahedron, in lexicographic order of their vertices, in
  // pinned memory. The complex must be whole, because its triangles and their classes are used.
  // Empty if there are more faces than codes. Throws std::bad_alloc and DeviceError.
  std::optional<SharedFaces> find(const DeviceComplex& complex);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace alphascope::gpu
