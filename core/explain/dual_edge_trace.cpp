// SPDX-License-Identifier: GPL-3.0-or-later
// Counts and lists what the dual-edge engine reports about one ball's simplices.
#include "core/explain/dual_edge_trace.hpp"

#include <cmath>

namespace alphascope {
namespace {

// The number of dual edges of each fate that are followed ball by ball.
constexpr std::size_t kMostSamples = 8;

RealPoint real_point(const Vector3<double>& v) {
  return {v.x, v.y, v.z};
}

void add(std::vector<StepSegment>& segments, const StepSegment& segment) {
  if (segments.size() < MarkedSimplices::kMostMarked) segments.push_back(segment);
}

}  // namespace

bool DualEdgeTraceSink::wants(int j, int k) const {
  return here() || ball(j) == about_ || ball(k) == about_;
}

LiftedVector<double> DualEdgeTraceSink::lifted(int slot) const {
  const BallIndex m = ball(slot);
  return lifted_as<double>(lifted_vector(balls_.centres[from_], balls_.radii[from_],
                                         balls_.centres[m], balls_.radii[m]));
}

RealPoint DualEdgeTraceSink::place(const DualEdge<double>& edge, double s) const {
  return balls_.lattice.unit_angstrom() *
         (alphascope::real_point(balls_.centres[from_]) + real_point(edge.foot()) +
          s * real_point(edge.direction()));
}

StepSegment DualEdgeTraceSink::segment(const DualEdge<double>& edge, double high,
                                       double low) const {
  return {StepMark::kept, current_.triangle, place(edge, -low), place(edge, high)};
}

void DualEdgeTraceSink::operator()(const ListNote& note) const {
  context_.cancel.throw_if_cancelled();
  list_.assign(note.balls.begin(), note.balls.end());
  edge_ = {};
  if (!here()) return;
  trace_.coverers = note.coverers;
  trace_.listed = list_;
  for (std::size_t k = 0; k < list_.size(); ++k) {
    if (note.covered[k] == 0) trace_.facing.push_back(list_[k]);
  }
}

void DualEdgeTraceSink::operator()(const CentreNote& note) const {
  edge_.integers = edge_.integers || note.exact;
  if (note.cuts == Decision::in) edge_.cut_by = note.m;
}

void DualEdgeTraceSink::operator()(const EdgeNote& note) const {
  context_.cancel.throw_if_cancelled();
  const CurrentEdge edge = edge_;
  edge_ = {};
  if (!here() && ball(note.j) != about_) return;
  const std::array<BallIndex, 2> ij{from_, ball(note.j)};
  TestTallies& fates = trace_.edges;
  fates.tested.add(here());
  if (edge.integers) fates.band.add(here());
  if (note.attached) {
    fates.conflict.add(here());
    fates.remove<2>(ball(edge.cut_by), ij);
    alphascope::add<2>(fates.open, ij);
  } else {
    (note.may_be_in ? fates.valid : fates.above_alpha).add(here());
    alphascope::add<2>(note.may_be_in ? fates.kept : fates.gone, ij);
  }
}

void DualEdgeTraceSink::operator()(const TripleNote& note) const {
  current_ = {};
  current_.triangle = {from_, ball(note.j), ball(note.k)};
  current_.j = note.j;
  current_.k = note.k;
  OptimisationTallies& triples = trace_.triples;
  (note.dropped ? triples.dropped : triples.kept).add(here());
  alphascope::add<3>(note.dropped ? triples.gone : triples.left, current_.triangle);
  if (triples.kept.all % 256 == 0) context_.cancel.throw_if_cancelled();
  if (triples.kept.all > kMostDualEdgesOfBall) throw TooManyDualEdges();
}

void DualEdgeTraceSink::operator()(const DualEdge<double>& edge) const {
  const double unit = balls_.lattice.unit_angstrom(),
               half = length(real_point(edge.direction())) * unit * edge.reach();
  current_.edge = edge;
  StepDualEdge& steps = current_.steps;
  steps.triangle = current_.triangle;
  steps.foot_angstrom = place(edge, 0);
  steps.direction = unit_vector(real_point(edge.direction()));
  steps.low_angstrom = -half;
  steps.high_angstrom = half;
}

void DualEdgeTraceSink::operator()(const DualEdge<double>& edge, int m,
                                   DualEdge<double>::Takes takes, bool gone) const {
  using Takes = DualEdge<double>::Takes;
  const double size = balls_.lattice.unit_angstrom() * length(real_point(edge.direction()));
  const bool moved = !gone && (edge.high().cutter == m || edge.low().cutter == m),
             unclear = !gone && !moved && !edge.ends_certain() && !current_.unsure;
  trace_.held.add(here());
  if (takes == Takes::nothing) trace_.far.add(here());
  if (moved) trace_.moved.add(here());
  if (gone) current_.taken_by = m;
  current_.unsure = !edge.ends_certain();
  current_.edge = edge;
  StepDualEdge& steps = current_.steps;
  // An empty rest has no ends, so the ends before this cut are kept.
  const double low = !gone                ? -size * edge.low().t
                     : steps.cuts.empty() ? steps.low_angstrom
                                          : steps.cuts.back().low_angstrom,
               high = !gone                ? size * edge.high().t
                      : steps.cuts.empty() ? steps.high_angstrom
                                           : steps.cuts.back().high_angstrom;
  steps.cuts.push_back({ball(m),
                        gone                      ? CutKind::takes_rest
                        : takes == Takes::nothing ? CutKind::too_far
                        : moved                   ? CutKind::moves_end
                        : unclear                 ? CutKind::unclear
                                                  : CutKind::nothing,
                        low, high});
}

void DualEdgeTraceSink::operator()(int high, int low) const {
  current_.ends = {high, low};
}

void DualEdgeTraceSink::operator()(int taken_by) const {
  current_.taken_by = taken_by;
}

void DualEdgeTraceSink::keep_sample(StepMark mark) const {
  const auto same = std::count_if(trace_.samples.begin(), trace_.samples.end(),
                                  [&](const StepDualEdge& edge) { return edge.mark == mark; });
  if (static_cast<std::size_t>(same) >= kMostSamples) return;
  current_.steps.mark = mark;
  trace_.samples.push_back(current_.steps);
}

void DualEdgeTraceSink::operator()(const FaceNote& note) const {
  filtered(note.exact);
  if (note.exact) exactly();
  const bool left =
      note.exact ? current_.ends.has_value() : current_.edge.has_value() && current_.taken_by < 0;
  if (left) decided(note.face);
}

// Notes the result of kernel II.
void DualEdgeTraceSink::filtered(bool open) const {
  TestTallies& fates = trace_.filter;
  fates.tested.add(here());
  if (open) {
    fates.band.add(here());
    alphascope::add<3>(fates.open, current_.triangle);
    if (current_.edge) keep_sample(StepMark::undecided);
  } else if (!current_.edge) {
    trace_.outside.add(here());
    alphascope::add<3>(fates.gone, current_.triangle);
  } else if (current_.taken_by >= 0) {
    fates.conflict.add(here());
    fates.remove<3>(ball(current_.taken_by), current_.triangle);
    alphascope::add<3>(fates.gone, current_.triangle);
    keep_sample(StepMark::dropped);
  } else {
    fates.valid.add(here());
    alphascope::add<3>(fates.kept, current_.triangle);
    keep_sample(StepMark::kept);
    add(trace_.filter_segments,
        segment(*current_.edge, current_.edge->high().t, current_.edge->low().t));
  }
}

// Notes the result of kernel III.
void DualEdgeTraceSink::exactly() const {
  TestTallies& fates = trace_.exact;
  fates.tested.add(here());
  if (!current_.ends) {
    if (current_.taken_by >= 0) {
      fates.conflict.add(here());
      fates.remove<3>(ball(current_.taken_by), current_.triangle);
    } else {
      fates.flat.add(here());
    }
    alphascope::add<3>(fates.gone, current_.triangle);
    return;
  }
  fates.valid.add(here());
  alphascope::add<3>(fates.kept, current_.triangle);
  // The ends are computed in double precision, for a picture. Kernel II may have had other ends.
  const auto [high, low] = *current_.ends;
  if (!current_.edge) return;
  const DualEdge<double>& edge = *current_.edge;
  const auto end = [&](int m, const DualEdge<double>::End& known) {
    if (m < 0) return known.t;
    const auto cut = edge.line_cut(lifted(m));
    return cut.slope != 0 ? cut.offset / std::abs(cut.slope) : known.t;
  };
  add(trace_.exact_segments, segment(edge, end(high, edge.high()), end(low, edge.low())));
}

// Notes the triangle and tetrahedra of a dual edge that has a rest.
void DualEdgeTraceSink::decided(const TriangleFace& face) const {
  const std::array<BallIndex, 3>& triangle = current_.triangle;
  trace_.left.add(here());
  if (face.in == Decision::out) {
    trace_.above_alpha.add(here());
    alphascope::add<3>(trace_.beyond, triangle);
    return;
  }
  trace_.triangles.add(here());
  if (face.attached != TriangleFace::Attached::no) trace_.attached.add(here());
  alphascope::add<3>(trace_.in, triangle);
  for (const int end : {face.high, face.low}) {
    if (end < 0) continue;
    std::array<BallIndex, 4> tetrahedron{triangle[0], triangle[1], triangle[2], ball(end)};
    std::sort(tetrahedron.begin(), tetrahedron.end());
    trace_.tetrahedra.insert(tetrahedron);
  }
}

}  // namespace alphascope
