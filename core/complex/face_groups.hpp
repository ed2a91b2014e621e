// SPDX-License-Identifier: GPL-3.0-or-later
// The faces of a sorted list of simplices, each with its cofaces. A coface of a face has one vertex
// more. (core/triangulation/incidence.hpp has the faces of a triangulation with their indices.)
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/complex/count_limits.hpp"
#include "core/complex/simplices.hpp"
#include "core/run/cancel_token.hpp"
#include "core/run/parallel.hpp"

namespace alphascope {

// The vertex of a coface that is not in its face.
template <int N>
BallIndex apex(const std::array<BallIndex, N + 1>& coface, const std::array<BallIndex, N>& face) {
  int n = 0;
  while (n < N && coface[n] == face[n]) ++n;
  return coface[n];
}

// For each vertex, the simplices with N + 1 vertices of which it is the first or second vertex.
// Only these have faces with N vertices that begin with it.
template <int N>
class AroundVertices {
 public:
  // The list must outlive this object. Throws std::length_error for too many simplices.
  explicit AroundVertices(const Simplices<N + 1>& cofaces) : cofaces_(cofaces) {
    require_face_records(cofaces.size(), N + 1);
    BallIndex end = 0;
    for (const auto& c : cofaces) end = std::max(end, c[1] + 1);
    from_.assign(std::size_t{end} + 1, 0);
    for (const auto& c : cofaces) {
      ++from_[c[0]];
      ++from_[c[1]];
    }
    std::uint32_t sum = 0;
    for (std::uint32_t& from : from_) from = std::exchange(sum, sum + from);
    around_.resize(sum);
    std::vector<std::uint32_t> next(from_.begin(), from_.end() - 1);
    for (std::uint32_t c = 0; c < cofaces.size(); ++c) {
      around_[next[cofaces[c][0]]++] = c;
      around_[next[cofaces[c][1]]++] = c;
    }
  }

  const Simplices<N + 1>& cofaces() const { return cofaces_; }
  // An upper bound (exclusive) on the first vertex of every face.
  BallIndex vertex_end() const { return static_cast<BallIndex>(from_.size() - 1); }
  // The simplices of this vertex, ascending.
  std::span<const std::uint32_t> of(BallIndex vertex) const {
    return {around_.data() + from_[vertex], around_.data() + from_[vertex + 1]};
  }
  // The end of the longest run of vertices from `vertex` on with at most `most` simplices together.
  // The run has at least one vertex.
  BallIndex after(BallIndex vertex, std::size_t most) const {
    const auto begin = from_.begin() + vertex;
    const auto end = std::upper_bound(begin, from_.end(), *begin + most);
    return std::max(vertex + 1, static_cast<BallIndex>(end - from_.begin() - 1));
  }

 private:
  const Simplices<N + 1>& cofaces_;
  std::vector<std::uint32_t> from_;  // per vertex: index of its first simplex in around_
  ResultArray<std::uint32_t> around_;
};

// The distinct faces with N vertices of a list of simplices with N + 1 vertices. They are in
// lexicographic order, each with the indices of its cofaces in that list, ascending.
template <int N>
class FaceGroups {
  static_assert(N >= 1 && N <= 3, "two vertices fit into a record's number");

 public:
  // Throws Cancelled after at most one pass over the simplices, and std::length_error for too many
  // simplices.
  explicit FaceGroups(const Simplices<N + 1>& cofaces, const CancelToken& cancel = {})
      : FaceGroups(AroundVertices<N>(cofaces), cancel) {}
  // Only the faces whose first vertex is in [begin, end). Throws Cancelled.
  FaceGroups(const AroundVertices<N>& around, BallIndex begin, BallIndex end,
             const CancelToken& cancel)
      : begin_(begin) {
    cancel.throw_if_cancelled();
    list_records(around, end, cancel);
    cancel.throw_if_cancelled();
    mark_faces();
    cancel.throw_if_cancelled();
  }

  std::size_t size() const { return faces_.size(); }
  const Simplices<N>& faces() const { return faces_; }

  // Calls visit(index of a coface) for each coface of this face.
  template <class Visit>
  void for_cofaces(std::size_t face, const Visit& visit) const {
    for (std::uint32_t r = first_record_[face]; r < first_record_[face + 1]; ++r) {
      visit(records_[r].coface);
    }
  }
  std::size_t coface_count(std::size_t face) const {
    return first_record_[face + 1] - first_record_[face];
  }

 private:
  // One face of one coface. Its first vertex is the bucket's, and the others are packed into one
  // number. This makes sorting faster, which takes half of the time: a molecule has some 40 records
  // per ball.
  using Rest = std::conditional_t<(N > 2), std::uint64_t, std::uint32_t>;
  struct Record {
    Rest rest;
    std::uint32_t coface;
    bool operator<(const Record& other) const {
      return rest != other.rest ? rest < other.rest : coface < other.coface;
    }
  };

  FaceGroups(const AroundVertices<N>& around, const CancelToken& cancel)
      : FaceGroups(around, 0, around.vertex_end(), cancel) {}

  static Record record(const std::array<BallIndex, N + 1>& coface, std::uint32_t c, int dropped) {
    Record record{0, c};
    for (int v = dropped == 0 ? 2 : 1; v <= N; ++v) {
      if (v == dropped) continue;
      if constexpr (N > 2) record.rest <<= 32;
      record.rest |= coface[v];
    }
    return record;
  }

  // Fills the records bucket by bucket, and sorts each bucket.
  void list_records(const AroundVertices<N>& around, BallIndex end, const CancelToken& cancel) {
    const auto& cofaces = around.cofaces();
    bucket_.assign(std::size_t{end} - begin_ + 1, 0);
    parallel_each(begin_, end, [&](BallIndex v) {
      std::uint32_t& count = bucket_[v - begin_ + 1];
      // The face without vertex 0 starts with vertex 1; every other face starts with vertex 0.
      for (const std::uint32_t c : around.of(v)) count += cofaces[c][0] == v ? N : 1;
    });
    std::partial_sum(bucket_.begin(), bucket_.end(), bucket_.begin());
    records_.resize(bucket_.back());
    parallel_each(begin_, end, [&](BallIndex v) {
      if (cancel.cancelled()) return;
      const auto begin = records_.begin() + bucket_[v - begin_];
      auto at = begin;
      for (const std::uint32_t c : around.of(v)) {
        const auto& coface = cofaces[c];
        if (coface[0] != v) {
          *at++ = record(coface, c, 0);
          continue;
        }
        for (int dropped = 1; dropped <= N; ++dropped) *at++ = record(coface, c, dropped);
      }
      if (N > 1) std::sort(begin, at);  // single vertices are in order already
    });
  }

  // Counts the faces of each bucket, then writes them to their places.
  void mark_faces() {
    const std::size_t buckets = bucket_.size() - 1;
    std::vector<std::uint32_t> first_face(buckets + 1, 0);
    parallel_each(0, buckets, [&](std::size_t b) {
      for_faces_of(b, [&](std::uint32_t) { ++first_face[b + 1]; });
    });
    std::partial_sum(first_face.begin(), first_face.end(), first_face.begin());
    faces_.resize(first_face.back());
    first_record_.resize(faces_.size() + 1);
    first_record_.back() = static_cast<std::uint32_t>(records_.size());
    parallel_each(0, buckets, [&](std::size_t b) {
      std::uint32_t at = first_face[b];
      for_faces_of(b, [&](std::uint32_t r) {
        std::array<BallIndex, N>& face = faces_[at];
        face[0] = begin_ + static_cast<BallIndex>(b);
        if constexpr (N > 1) face[N - 1] = static_cast<BallIndex>(records_[r].rest);
        if constexpr (N > 2) face[1] = static_cast<BallIndex>(records_[r].rest >> 32);
        first_record_[at++] = r;
      });
    });
  }

  // Calls visit(first record) for each face of a bucket.
  template <class Visit>
  void for_faces_of(std::size_t b, const Visit& visit) const {
    for (std::uint32_t r = bucket_[b]; r < bucket_[b + 1]; ++r) {
      if (r == bucket_[b] || records_[r].rest != records_[r - 1].rest) visit(r);
    }
  }

  const BallIndex begin_;              // vertex of the first bucket
  std::vector<std::uint32_t> bucket_;  // per first vertex: index of its first record
  ResultArray<Record> records_;
  Simplices<N> faces_;
  ResultArray<std::uint32_t> first_record_;
};

// The number of simplices around vertices that for_face_groups() takes at a time.
inline constexpr std::size_t kSimplicesAtATime = std::size_t{1} << 16;

// Calls visit(groups) for groups of all faces, in order, with few first vertices at a time. The
// records of all faces of a large triangulation would need as much memory as its filtration. Throws
// as FaceGroups does.
template <int N, class Visit>
void for_face_groups(const Simplices<N + 1>& cofaces, const CancelToken& cancel, const Visit& visit,
                     std::size_t simplices_at_a_time = kSimplicesAtATime) {
  const AroundVertices<N> around(cofaces);
  for (BallIndex begin = 0; begin < around.vertex_end();) {
    const BallIndex end = around.after(begin, simplices_at_a_time);
    visit(FaceGroups<N>(around, begin, end, cancel));
    begin = end;
  }
}

// Sorts simplices in lexicographic order; their first vertices are below `vertex_end`. Throws
// Cancelled, with the list unchanged, and std::length_error for too many simplices.
template <int N>
void sort_simplices(Simplices<N>& simplices, std::size_t vertex_end,
                    const CancelToken& cancel = {}) {
  require_face_records(simplices.size(), 1);
  std::vector<std::uint32_t> bucket(vertex_end + 1, 0);
  for (const auto& s : simplices) ++bucket[s[0]];
  std::uint32_t sum = 0;
  for (std::uint32_t& b : bucket) {
    const std::uint32_t count = b;
    b = sum;
    sum += count;
  }
  Simplices<N> sorted(simplices.size());
  std::vector<std::uint32_t> next(bucket.begin(), bucket.end() - 1);
  for (const auto& s : simplices) sorted[next[s[0]]++] = s;
  parallel_each(0, vertex_end, [&](std::size_t v) {
    if (cancel.cancelled()) return;
    std::sort(sorted.begin() + bucket[v], sorted.begin() + bucket[v + 1]);
  });
  cancel.throw_if_cancelled();
  simplices.swap(sorted);
}

}  // namespace alphascope
