// Networks listed as their parts: what they fall into as alpha grows, with the alpha and the
// tetrahedra that they have now. Definition: docs/algorithm.md, Networks.
#pragma once

#include "core/cavity/cavities.hpp"
#include "core/geometry/alpha.hpp"

namespace alphascope {

// Each network of `found` that falls apart is replaced by two or more parts; the others stay as
// they are, and so do Betti numbers. Parts have together exactly the tetrahedra and the triangles
// of mouths of the network. Each has its own deepest sink, that of the network among them. A mouth
// that is in front of two parts becomes one of each. A face between parts is in Cavity::passages of
// both. Of the K_alpha of find_cavities(), in which `membership` and `rule` are as well. Works in
// the caller's task arena; the same for any number of threads, and in whatever order the balls are
// listed. Throws Cancelled.
Cavities split_networks(const CavityGround& ground, const Membership& membership, Cavities found,
                        const Alpha& alpha_angstrom2, OutsideRule rule = OutsideRule::castp,
                        const CancelToken& cancel = {});

}  // namespace alphascope
