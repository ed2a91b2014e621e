// What BallSimplices tells whoever wants to show how it finds the simplices of a ball; its own sink
// is empty (core/predicates/recording.hpp). Balls are named by their slot in the list of
// neighbours that ListNote brings.
#pragma once

#include <cstddef>
#include <span>

#include "core/dual_edge/triangle_faces.hpp"
#include "core/geometry/ball_set.hpp"

namespace alphascope {

// The neighbours that are left, ascending.
struct ListNote {
  std::span<const BallIndex> balls;
  std::span<const char> covered;  // whether the disc of one is covered: then it only cuts
  // So many balls, whose planes are nearest, were tried as covers; 0: none, the list is short.
  std::size_t coverers;
};

// Ball m was held against the orthocentre of edge ij.
struct CentreNote {
  int j, m;
  bool exact;  // the filter left it open
  Decision cuts;
};
// After the last of them. What is not attached and not in K_alpha goes no further.
struct EdgeNote {
  int j;
  bool attached, may_be_in;
};

// Three balls of which each two meet; an edge ik that is not in K_alpha ends it here.
struct TripleNote {
  int j, k;
  bool dropped;
};

// Its dual edge, decided.
struct FaceNote {
  int j, k;
  bool exact;  // the filter left it open
  TriangleFace face;
};

class BallSimplicesSink {
 public:
  virtual ~BallSimplicesSink() = default;
  // Is anything asked about the triangle of i, j and k? If not, it is left out.
  virtual bool wants(int j, int k) const = 0;

  virtual void operator()(const ListNote&) const = 0;
  virtual void operator()(const CentreNote&) const = 0;
  virtual void operator()(const EdgeNote&) const = 0;
  virtual void operator()(const TripleNote&) const = 0;
  // As clipped_edge() and exact_ends() say, between a triangle's two notes.
  virtual void operator()(const DualEdge<double>&) const = 0;
  virtual void operator()(const DualEdge<double>&, int m, DualEdge<double>::Takes,
                          bool gone) const = 0;
  virtual void operator()(int high, int low) const = 0;
  virtual void operator()(int taken_by) const = 0;
  virtual void operator()(const FaceNote&) const = 0;
};

}  // namespace alphascope
