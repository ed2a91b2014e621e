// Finds on the device what core/triangulation/outer_faces.hpp finds on the CPU. Plain C++.
#pragma once

#include <memory>
#include <optional>

#include "core/complex/face_code.hpp"
#include "gpu/memory/device_complex.hpp"

namespace alphascope::gpu {

class OutsideFinder {
 public:
  OutsideFinder();  // throws DeviceError
  ~OutsideFinder();

  // The faces of tetrahedra that no other tetrahedron has, in lexicographic order of their
  // vertices, in pinned memory. Of a whole complex: its triangles and their classes are looked at.
  // Nothing where there are more faces than codes. Throws std::bad_alloc, DeviceError.
  std::optional<SharedFaces> find(const DeviceComplex& complex);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace alphascope::gpu
