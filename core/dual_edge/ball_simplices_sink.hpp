// SPDX-License-Identifier: GPL-3.0-or-later
// The interface through which BallSimplices reports how it finds the simplices of a ball. The
// engine itself uses an empty sink (core/predicates/recording.hpp). Balls are named by their slot
// in the list of neighbours of the ListNote.
#pragma once

#include <cstddef>
#include <span>

#include "core/dual_edge/triangle_faces.hpp"
#include "core/geometry/ball_set.hpp"

namespace alphascope {

// The neighbours that are left after culling, in ascending order.
struct ListNote {
  std::span<const BallIndex> balls;
  std::span<const char> covered;  // 1: the disc of this neighbour is covered, and it only cuts
  // Number of balls tried as covers, those with the nearest planes; 0 if the list is short and not
  // culled.
  std::size_t coverers;
};

// The orthocentre of edge ij was tested against ball m.
struct CentreNote {
  int j, m;
  bool exact;  // the filter left it open
  Decision cuts;
};
// Follows the last CentreNote of edge ij. An edge that is neither attached nor in K_alpha is
// dropped.
struct EdgeNote {
  int j;
  bool attached, may_be_in;
};

// Three balls of which each two meet. `dropped`: edge ik is not in K_alpha, so the triangle is not
// tested.
struct TripleNote {
  int j, k;
  bool dropped;
};

// The decision about the dual edge of the triangle in the last TripleNote.
struct FaceNote {
  int j, k;
  bool exact;  // the filter left it open
  TriangleFace face;
};

class BallSimplicesSink {
 public:
  virtual ~BallSimplicesSink() = default;
  // Is the triangle of i, j and k to be shown? If not, it is skipped.
  virtual bool wants(int j, int k) const = 0;

  virtual void operator()(const ListNote&) const = 0;
  virtual void operator()(const CentreNote&) const = 0;
  virtual void operator()(const EdgeNote&) const = 0;
  virtual void operator()(const TripleNote&) const = 0;
  // Called by clipped_edge() and exact_ends(), between the TripleNote and the FaceNote of a
  // triangle.
  virtual void operator()(const DualEdge<double>&) const = 0;
  virtual void operator()(const DualEdge<double>&, int m, DualEdge<double>::Takes,
                          bool gone) const = 0;
  virtual void operator()(int high, int low) const = 0;
  virtual void operator()(int taken_by) const = 0;
  virtual void operator()(const FaceNote&) const = 0;
};

}  // namespace alphascope
