// SPDX-License-Identifier: GPL-3.0-or-later
// The templates by which BallSimplices finds all simplices of one ball, for any sink.
// ball_simplices.cpp instantiates them with the empty sink, ball_simplices_recorded.cpp with a real
// one. The two sources are separate so that compilers optimise the engine's code as if the other
// did not exist.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <span>
#include <type_traits>

#include "core/dual_edge/ball_simplices.hpp"

namespace alphascope {

template <class Sink>
bool BallSimplices::edge_is_attached(int j, const FacetDisc<double>& disc, const Sink& sink) {
  const TriangleRows common{j, j, row(j), row(j)};
  for (int m = common.next_common(-1, words_); m >= 0; m = common.next_common(m, words_)) {
    Decision d = filter_ ? disc.centre_cut_by(vector(m)) : Decision::unknown;
    const bool open = d == Decision::unknown;
    if (open) d = edge_attached_to<ExactDecider>(surroundings(), j, m);
    sink(CentreNote{j, m, open, d});
    if (d == Decision::in) return true;
  }
  return false;
}

template <class Sink>
void BallSimplices::add_edge(int j, BlockOutput& out, const Sink& sink) {
  float value = HUGE_VALF;
  const bool attached = edge_is_attached(j, FacetDisc<double>(vector(j), radius_square_), sink);
  if (!attached && decide_simplex<ExactDecider>(surroundings(), &value, j) == Decision::out) {
    dead_[static_cast<std::size_t>(j)] = 1;
    sink(EdgeNote{j, false, false});
    return;
  }
  sink(EdgeNote{j, attached, true});
  edge_[static_cast<std::size_t>(j - first_)] = out.edges.size();
  out.edges.simplices.push_back({i_, neighbours_.ball(j)});
  out.edges.values.push_back(value);
  out.edges.states.push_back(attached ? 0 : kUnattached);
}

template <class Sink>
TriangleFace BallSimplices::exactly(const TriangleRows& rows, const Sink& sink) {
  const auto start = std::chrono::steady_clock::now();
  ++exact_dual_edges_;
  const bool small = largest_offset_ < kSmallOffset && largest_power_ < kSmallPower;
  const TriangleFace face = small ? exact_face<Int128>(surroundings(), rows, words_, sink)
                                  : exact_face<WideInt<4>>(surroundings(), rows, words_, sink);
  exact_milliseconds_ +=
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return face;
}

// A real sink gets every cut, so no cut may be sieved out for it.
template <class Sink, class Body>
auto BallSimplices::filtered(const NearFirstRows& rows, const Body& body) {
  const auto vectors = [&](int k) { return vector(k); };
  const TriangleRows& plain = rows;
  if constexpr (std::is_same_v<Sink, NoSink>) {
    return body(SievedRows{plain, &doubles_, sieved_.data()}, vectors);
  } else {
    return culled_ ? body(rows, vectors) : body(plain, vectors);
  }
}

template <class Sink>
void BallSimplices::triangle(const NearFirstRows& t, BlockOutput& out, const Sink& sink) {
  TriangleFace face = TriangleFace::undecided();
  if (filter_) {
    face = filtered<Sink>(t, [&](const auto& rows, const auto& vectors) {
      return filtered_face<double>(rows, words_, radius_square_, vectors, sink);
    });
  }
  const bool open = face.in == Decision::unknown;
  if (open) face = exactly(t, sink);
  sink(FaceNote{t.j, t.k, open, face});
  if (face.in == Decision::out) return;
  const std::array<BallIndex, 3> ijk{i_, neighbours_.ball(t.j), neighbours_.ball(t.k)};
  float value = 0;
  triangle_value<ExactDecider>(surroundings(), t.j, t.k, face, &value);
  out.triangles.simplices.push_back(ijk);
  out.triangles.values.push_back(value);
  const SimplexClass own = triangle_class(face.cofaces());
  out.triangles.states.push_back(static_cast<std::uint8_t>(own));
  note_coface(t.j, value, own, out);
  note_coface(t.k, value, own, out);
  for (const int l : {std::min(face.low, face.high), std::max(face.low, face.high)}) {
    if (l <= t.k) continue;
    decide_simplex<ExactDecider>(surroundings(), &value, t.j, t.k, l);
    out.tetrahedra.simplices.push_back({ijk[0], ijk[1], ijk[2], neighbours_.ball(l)});
    out.tetrahedra.values.push_back(value);
  }
}

template <class Sink>
void BallSimplices::triangles_of(int j, BlockOutput& out, const Sink& sink) {
  const TriangleRows ij{j, j, row(j), row(j)};
  for (int k = ij.next_common(j, words_); k >= 0; k = ij.next_common(k, words_)) {
    if constexpr (!std::is_same_v<Sink, NoSink>) {
      if (!sink.wants(j, k)) continue;
    }
    const bool dead = dead_[static_cast<std::size_t>(k)] != 0;
    sink(TripleNote{j, k, dead});
    if (dead) continue;
    const NearFirstRows t{{j, k, row(j), row(k)}, near_.data()};
    if (!whole_ && !t.has_fourth(words_)) continue;
    ++dual_edges_;
    whole_ ? triangle(t, out, sink) : tetrahedra(t, out);
  }
}

template <class Sink>
VertexState BallSimplices::process_with(std::uint32_t slot, std::span<const std::uint32_t> list,
                                        BlockOutput& out, const Sink& sink) {
  load(slot, list);
  const int n = static_cast<int>(neighbours_.size()), later = n - first_;
  sink(ListNote{
      neighbours_.balls, {dead_.data(), neighbours_.size()}, culled_ ? coverers_.size() : 0});
  if (!whole_ && later < 3) return VertexState::absent;  // vertices are not requested
  const auto alive = [&](int j) { return dead_[static_cast<std::size_t>(j)] == 0; };
  rows_.resize(static_cast<std::size_t>(later) * static_cast<std::size_t>(words_));
  edge_.resize(static_cast<std::size_t>(later));
  for (int j = first_; j < n; ++j) {
    if (!alive(j)) continue;
    fill_row(j);
    if (whole_) add_edge(j, out, sink);
  }
  for (int j = first_; j < n; ++j) {
    if (alive(j)) triangles_of(j, out, sink);
  }
  return whole_ ? vertex_state() : VertexState::absent;
}

}  // namespace alphascope
