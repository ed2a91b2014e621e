// Which cofaces each face of a sorted list of simplices has: the one place where faces are
// generated.
#pragma once

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "core/complex/count_limits.hpp"
#include "core/complex/simplices.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// The vertex of a coface that a face of it lacks.
template <int N>
BallIndex apex(const std::array<BallIndex, N + 1>& coface, const std::array<BallIndex, N>& face) {
  int n = 0;
  while (n < N && coface[n] == face[n]) ++n;
  return coface[n];
}

// The distinct faces with N vertices of a list of simplices with N + 1, in lexicographic order,
// each with the indices of its cofaces in that list, ascending.
template <int N>
class FaceGroups {
  static_assert(N >= 1 && N <= 3, "two vertices fit into a record's number");

 public:
  // Throws Cancelled, with no more than one pass over the simplices after the token was, and
  // std::length_error for too many simplices.
  explicit FaceGroups(const Simplices<N + 1>& cofaces, const CancelToken& cancel = {}) {
    require_face_records(cofaces.size(), N + 1);
    bucket_by_first_vertex(cofaces);
    cancel.throw_if_cancelled();
    sort_buckets(cancel);
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
  // One face of one coface; its first vertex is the bucket's, the others are packed into a number
  // (sorting is half of the work, and there are 40 records per ball).
  using Rest = std::conditional_t<(N > 2), std::uint64_t, std::uint32_t>;
  struct Record {
    Rest rest;
    std::uint32_t coface;
    bool operator<(const Record& other) const {
      return rest != other.rest ? rest < other.rest : coface < other.coface;
    }
  };

  void bucket_by_first_vertex(const Simplices<N + 1>& cofaces) {
    BallIndex end = 0;
    for (const auto& c : cofaces) end = std::max(end, c[N] + 1);
    bucket_.assign(std::size_t{end} + 1, 0);
    // Dropping vertex 0 leaves vertex 1 first; every other face starts with vertex 0.
    for (const auto& c : cofaces) {
      bucket_[c[0]] += N;
      bucket_[c[1]] += 1;
    }
    std::uint32_t sum = 0;
    for (std::uint32_t& b : bucket_) {
      const std::uint32_t count = b;
      b = sum;
      sum += count;
    }
    records_.resize(sum);
    std::vector<std::uint32_t> next(bucket_.begin(), bucket_.end() - 1);
    for (std::uint32_t c = 0; c < cofaces.size(); ++c) {
      for (int dropped = 0; dropped <= N; ++dropped) {
        Record record{0, c};
        for (int v = dropped == 0 ? 2 : 1; v <= N; ++v) {
          if (v == dropped) continue;
          if constexpr (N > 2) record.rest <<= 32;
          record.rest |= cofaces[c][v];
        }
        records_[next[cofaces[c][dropped == 0 ? 1 : 0]]++] = record;
      }
    }
  }

  void sort_buckets(const CancelToken& cancel) {
    if constexpr (N > 1) {  // vertices: the records of a bucket are in order already
      tbb::parallel_for(std::size_t{0}, bucket_.size() - 1, [&](std::size_t v) {
        if (cancel.cancelled()) return;
        std::sort(records_.begin() + bucket_[v], records_.begin() + bucket_[v + 1]);
      });
    }
  }

  // Counts the faces of each bucket, then writes them to where they belong.
  void mark_faces() {
    const std::size_t buckets = bucket_.size() - 1;
    std::vector<std::uint32_t> first_face(buckets + 1, 0);
    tbb::parallel_for(std::size_t{0}, buckets, [&](std::size_t v) {
      for_faces_of(v, [&](std::uint32_t) { ++first_face[v + 1]; });
    });
    for (std::size_t v = 0; v < buckets; ++v) first_face[v + 1] += first_face[v];
    faces_.resize(first_face.back());
    first_record_.resize(faces_.size() + 1);
    first_record_.back() = static_cast<std::uint32_t>(records_.size());
    tbb::parallel_for(std::size_t{0}, buckets, [&](std::size_t v) {
      std::uint32_t at = first_face[v];
      for_faces_of(v, [&](std::uint32_t r) {
        std::array<BallIndex, N>& face = faces_[at];
        face[0] = static_cast<BallIndex>(v);
        if constexpr (N > 1) face[N - 1] = static_cast<BallIndex>(records_[r].rest);
        if constexpr (N > 2) face[1] = static_cast<BallIndex>(records_[r].rest >> 32);
        first_record_[at++] = r;
      });
    });
  }

  // Calls visit(first record) for each face whose first vertex is v.
  template <class Visit>
  void for_faces_of(std::size_t v, const Visit& visit) const {
    for (std::uint32_t r = bucket_[v]; r < bucket_[v + 1]; ++r) {
      if (r == bucket_[v] || records_[r].rest != records_[r - 1].rest) visit(r);
    }
  }

  std::vector<std::uint32_t> bucket_;  // first record of each first vertex
  std::vector<Record> records_;
  Simplices<N> faces_;
  std::vector<std::uint32_t> first_record_;
};

// Puts simplices into lexicographic order; their first vertices are below `vertex_end`. Throws
// Cancelled (then they are as they were), std::length_error for too many.
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
  tbb::parallel_for(std::size_t{0}, vertex_end, [&](std::size_t v) {
    if (cancel.cancelled()) return;
    std::sort(sorted.begin() + bucket[v], sorted.begin() + bucket[v + 1]);
  });
  cancel.throw_if_cancelled();
  simplices.swap(sorted);
}

}  // namespace alphascope
