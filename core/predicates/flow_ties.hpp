// SPDX-License-Identifier: GPL-3.0-or-later
// The rule for ties of the discrete flow.
#pragma once

namespace alphascope {

// The rule for ties: the orthocentre lies in the plane of a face.
enum class FlowTies {
  perturbed,  // the perturbed weights decide, as in the triangulation
  strict      // a tie is no flow
};

}  // namespace alphascope
