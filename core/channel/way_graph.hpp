// SPDX-License-Identifier: GPL-3.0-or-later
// The empty space of a molecule as a graph of tetrahedra. Ways lead through it from outside to
// outside along an axis. The decision which ways are open is exact; all else is rounded.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/channel/envelope.hpp"
#include "core/clearance/empty_space.hpp"
#include "core/clearance/equal_clearance.hpp"
#include "core/clearance/grown_triangulation.hpp"
#include "core/complex/simplices.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/real_point.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// The region for a way. It leads from outside the envelope of all balls, below a part's middle, to
// outside above it. In the middle third of the part the way stays near the axis. Elsewhere it is
// free.
class WayAxis {
 public:
  // The axis passes through the mean centre of these balls; there must be at least one. `axis` is a
  // unit vector.
  WayAxis(const BallSet& balls, const std::vector<BallIndex>& part, const RealPoint& axis);

  const RealPoint& axis() const { return axis_; }
  double low() const { return low_; }  // range of the part's centres, Å along the axis
  double high() const { return high_; }
  double along(const RealPoint& x) const { return dot(axis_, x); }  // Å
  double from_axis(const RealPoint& x) const;                       // distance, Å

  // -1: in the part's lower third or below; 1: in the upper third or above; 0: in the middle third.
  int zone(const RealPoint& x) const;
  int side(const RealPoint& x) const { return along(x) < (low_ + high_) / 2 ? -1 : 1; }
  // Returns whether x is near the axis: not farther than half the root mean square distance of the
  // part's atoms from the axis at this height.
  bool is_near(const RealPoint& x) const;
  // Returns whether a straight step is near the axis wherever it passes the middle third.
  bool stays_near_axis(const RealPoint& from, const RealPoint& to) const;

 private:
  static constexpr double kSlab = 2;  // Å
  std::size_t slab_of(double along) const;

  RealPoint middle_, axis_;  // Å
  double low_ = 0, high_ = 0;
  std::vector<double> near_;  // Å, for each slab: the distance up to which is_near() holds
};

// An open triangle between tetrahedra `a` < `b` of a graph.
struct WayFace {
  std::uint32_t a, b;
  // The power distance (square lattice units) across it. It orders ways as K does. Orders by power
  // and by clearance differ where radii differ.
  float power;
};

// An open triangle where ways may cross: a ring of balls surrounds it, and it alone closes the way
// as the balls grow.
struct WayRing {
  std::uint32_t face;         // index in WayGraph::faces()
  double clearance_angstrom;  // of the triangle
  double widest_angstrom;     // the largest clearance of this triangle and all later ones
};

// The tetrahedra that a way can pass, with the open faces between them. They have numbers of their
// own, in the order of faces(): a search that goes through these finds tetrahedra near each other.
class WayGraph {
 public:
  // `balls` must be on a lattice that passage_digits() allows, and outlive this object.
  WayGraph(const BallSet& balls, const Envelope& envelope, const RunContext& context);

  static constexpr std::uint32_t kNothing = ~std::uint32_t{0};
  // A face as seen from one of its tetrahedra. `to` is kNothing where no way leads through.
  struct Link {
    std::uint32_t to;
    std::uint32_t face;  // index in faces()
    float power;
    float gap_angstrom;  // the clearance (Å) if a way across is narrowest on the face, or infinity
  };

  std::uint32_t size() const { return static_cast<std::uint32_t>(corner_.size()); }
  const RealPoint& corner(std::uint32_t tetrahedron) const { return corner_[tetrahedron]; }  // Å
  // Returns whether it is outside the envelope. Ways end there.
  bool is_outside(std::uint32_t tetrahedron) const { return is_outside_[tetrahedron] != 0; }
  const std::array<Link, 4>& links(std::uint32_t tetrahedron) const { return links_[tetrahedron]; }
  // The link from one tetrahedron to another beside it.
  std::size_t link_to(std::uint32_t from, std::uint32_t to) const;

  // Sorted by falling power. Equal powers have a fixed order.
  const ResultArray<WayFace>& faces() const { return faces_; }
  // In the order of faces().
  const std::vector<WayRing>& rings() const { return rings_; }
  EqualClearance gap_at(std::uint32_t tetrahedron, std::size_t link) const;
  // ∫ dl / clearance² across a face, as for a channel's curve. It is computed once. Several threads
  // may call this.
  double cost_across(std::uint32_t tetrahedron, std::size_t link) const;

 private:
  struct OpenFace;

  ResultArray<OpenFace> open_faces(const std::vector<std::uint8_t>& kinds,
                                   const std::vector<float>& powers,
                                   const CancelToken& cancel) const;
  bool set_gap(OpenFace& face) const;
  static ResultArray<OpenFace> sorted(const ResultArray<OpenFace>& faces);
  EqualClearance gap_of(const std::array<BallIndex, 3>& triangle) const;

  const BallSet& balls_;
  std::shared_ptr<const GrownTriangulation> scene_;
  std::optional<EmptySpace> space_;
  std::vector<std::uint32_t> original_;  // of each tetrahedron its index in the triangulation
  std::vector<RealPoint> corner_;
  std::vector<std::uint8_t> is_outside_;
  ResultArray<std::array<Link, 4>> links_;
  ResultArray<WayFace> faces_;
  std::vector<WayRing> rings_;
  WayCost way_cost_;
  mutable std::vector<std::atomic<double>> costs_;  // of each face; 0 is not known yet
};

}  // namespace alphascope
