// SPDX-License-Identifier: GPL-3.0-or-later
// The kernels of the tuple engine: neighbours, tuples (kernel I), filtered validity (kernel II),
// exact validity (kernel III), and the output of valid simplices. Each function object does the
// work of one item, for the CPU and the CUDA executor. tuple_pipeline.hpp has their order.
//
// Source: N. P. Ranjanikar's thesis, sections 3.2.4 to 3.2.7. Two departures: tuples are counted
// and then written, not written into space for the largest possible number. And simplices of lower
// dimension are tested as tetrahedra are, which gives the whole complex.
#pragma once

#include "core/tuples/tuple_exact.hpp"
#include "core/tuples/tuple_float.hpp"

namespace alphascope {

// ---- prefix sums and batches ----

struct ReadCount {
  const std::uint32_t* counts;
  ALPHASCOPE_HOST_DEVICE std::uint32_t operator()(std::uint64_t n) const { return counts[n]; }
};

// The end of a batch of items (exclusive), and the sum over its items.
struct BatchEnd {
  std::uint64_t item, sum;
};

// Finds the longest batch that begins at `first` and has a sum of at most `capacity`. It has at
// least one item.
struct FindBatch {
  const std::uint64_t* sums;  // count + 1 prefix sums
  std::uint64_t count, first, capacity;
  BatchEnd* result;
  ALPHASCOPE_HOST_DEVICE void operator()(std::uint64_t) const {
    std::uint64_t good = first + 1, bad = count + 1;
    while (bad - good > 1) {
      const std::uint64_t middle = good + (bad - good) / 2;
      (sums[middle] - sums[first] <= capacity ? good : bad) = middle;
    }
    *result = {good, sums[good] - sums[first]};
  }
};

// ---- kernel I: neighbours, and tuples of them ----

template <class Reader>
struct CountNeighbours {
  TupleInput<Reader> scene;
  std::uint32_t* counts;
  ALPHASCOPE_HOST_DEVICE void operator()(std::uint64_t slot) const {
    std::uint32_t count = 0;
    for_balls_in_cube(scene, static_cast<std::uint32_t>(slot), [&](std::uint32_t) { ++count; });
    counts[slot] = count;
  }
};

template <class Reader>
struct FillNeighbours {
  TupleInput<Reader> scene;
  NeighbourLists lists;
  std::uint32_t first_slot;
  std::uint32_t* slots;
  std::uint32_t* owners;  // for each place in the lists: the ball whose list it is
  ALPHASCOPE_HOST_DEVICE void operator()(std::uint64_t n) const {
    const std::uint32_t slot = first_slot + static_cast<std::uint32_t>(n);
    std::uint32_t at = lists.begin(slot);
    for_balls_in_cube(scene, slot, [&](std::uint32_t t) {
      slots[at] = t;
      owners[at++] = slot;
    });
  }
};

// Does the edge optimisation keep the pair of balls i and j?
template <class Reader>
ALPHASCOPE_INLINE bool is_pair_kept(const TupleInput<Reader>& scene, std::uint32_t i,
                                    std::uint32_t j) {
  return !scene.edge_optimisation || grown_balls_may_meet(scene, i, j);
}

// Marks each place in the lists: 1 if ball and neighbour become a pair.
template <class Reader>
struct MarkPairs {
  TupleInput<Reader> scene;
  NeighbourLists lists;
  const std::uint32_t* owners;
  std::uint32_t* marks;
  ALPHASCOPE_HOST_DEVICE void operator()(std::uint64_t at) const {
    const std::uint32_t i = owners[at], j = lists.slots[at];
    marks[at] = j > i && is_pair_kept(scene, i, j) ? 1 : 0;
  }
};

struct FillPairs {
  const std::uint32_t* owners;
  const std::uint64_t* sums;
  BallTuple<2>* pairs;
  ALPHASCOPE_HOST_DEVICE void operator()(std::uint64_t at) const {
    if (sums[at] == sums[at + 1]) return;
    pairs[sums[at]] = {owners[at], {static_cast<std::uint32_t>(at)}};
  }
};

struct FillSingles {
  std::uint32_t first_slot;
  BallTuple<1>* singles;
  ALPHASCOPE_HOST_DEVICE void operator()(std::uint64_t n) const {
    singles[n] = {first_slot + static_cast<std::uint32_t>(n), {0}};
  }
};

template <int N, class Reader>
ALPHASCOPE_INLINE FloatCentre centre_of(const TupleInput<Reader>& scene,
                                        const NeighbourLists& lists, const BallTuple<N>& tuple) {
  const BallRecord i = scene.read.ball(tuple.first);
  FloatLifted v[N - 1];
  for (int n = 0; n < N - 1; ++n) v[n] = float_lifted(i, scene.read.ball(tuple.slot(lists, n + 1)));
  if constexpr (N == 2) {
    return float_centre(v[0]);
  } else if constexpr (N == 3) {
    return float_centre(v[0], v[1]);
  } else {
    return float_centre(v[0], v[1], v[2]);
  }
}

template <class Reader>
ALPHASCOPE_INLINE Decision within_alpha(const TupleInput<Reader>& scene, std::uint32_t first,
                                        const FloatCentre& centre) {
  if (scene.alpha_covers_all) return Decision::in;
  return centre_within(centre, scene.read.ball(first).radius, scene.alpha_float);
}

enum class Optimisation : std::uint8_t { edge, alpha };

// Calls visit(tuple) for every tuple that extends `base` by one later neighbour. Returns the number
// of tuples that the edge optimisation keeps. The alpha optimisation drops 4-tuples with rho >
// alpha. For each dropped tuple `sink` gets the optimisation and the place of the added neighbour.
template <int N, class Reader, class Visit, class Sink = NoSink>
ALPHASCOPE_INLINE std::uint32_t for_extensions(const TupleInput<Reader>& scene,
                                               const NeighbourLists& lists,
                                               const BallTuple<N>& base, const Visit& visit,
                                               const Sink& sink = {}) {
  std::uint32_t considered = 0;
  BallTuple<N + 1> tuple;
  tuple.first = base.first;
  for (int n = 0; n < N - 1; ++n) tuple.at[n] = base.at[n];
  const std::uint32_t end = lists.end(base.first);
  for (std::uint32_t at = base.at[N - 2] + 1; at < end; ++at) {
    if (scene.edge_optimisation) {
      bool meet = true;
      for (int n = 0; n < N && meet; ++n) {
        meet = grown_balls_may_meet(scene, base.slot(lists, n), lists.slots[at]);
      }
      if (!meet) {
        sink(Optimisation::edge, at);
        continue;
      }
    }
    ++considered;
    tuple.at[N - 1] = at;
    if constexpr (N == 3) {
      if (scene.alpha_optimisation && scene.float_holds &&
          within_alpha(scene, tuple.first, centre_of<4>(scene, lists, tuple)) == Decision::out) {
        sink(Optimisation::alpha, at);
        continue;
      }
    }
    visit(tuple);
  }
  return considered;
}

template <int N, class Reader>
struct CountExtensions {
  TupleInput<Reader> scene;
  NeighbourLists lists;
  const BallTuple<N>* bases;
  std::uint32_t* counts;
  std::uint32_t* considered;
  ALPHASCOPE_HOST_DEVICE void operator()(std::uint64_t b) const {
    std::uint32_t count = 0;
    considered[b] =
        for_extensions<N>(scene, lists, bases[b], [&](const BallTuple<N + 1>&) { ++count; });
    counts[b] = count;
  }
};

// Writes tuples in the order in which they were counted. The tuples of bases from `first` on begin
// at index sums[base] - sums[first].
template <int N, class Reader>
struct FillExtensions {
  TupleInput<Reader> scene;
  NeighbourLists lists;
  const BallTuple<N>* bases;
  const std::uint64_t* sums;
  std::uint64_t first;
  BallTuple<N + 1>* tuples;
  ALPHASCOPE_HOST_DEVICE void operator()(std::uint64_t n) const {
    BallTuple<N + 1>* to = tuples + (sums[first + n] - sums[first]);
    if (sums[first + n] == sums[first + n + 1]) return;
    for_extensions<N>(scene, lists, bases[first + n],
                      [&](const BallTuple<N + 1>& tuple) { *to++ = tuple; });
  }
};

// ---- kernels II and III: is the orthosphere empty, and rho <= alpha? ----

enum class Verdict : std::uint8_t { invalid, valid, band };

template <int N>
ALPHASCOPE_INLINE bool has_place(const BallTuple<N>& tuple, std::uint32_t at) {
  bool has = false;
  for (int n = 0; n < N - 1; ++n) has = has || tuple.at[n] == at;
  return has;
}

// The reports of a test to its sink. above_alpha: rho is above alpha. flat: the balls are affinely
// dependent. conflict: the ball in this place of the list is in conflict, which ends the test.
// unsure: single precision cannot decide about that ball.
enum class TupleNote : std::uint8_t { above_alpha, flat, conflict, unsure };

// Integers, which are as fast as floats here. With equality the larger simplices decide
// (tuple_exact.hpp).
template <class Reader, class Sink>
ALPHASCOPE_INLINE Verdict filter_vertex(const TupleInput<Reader>& scene,
                                        const NeighbourLists& lists, std::uint32_t slot,
                                        const Sink& sink) {
  const BallRecord i = scene.read.ball(slot);
  for (std::uint32_t at = lists.begin(slot); at < lists.end(slot); ++at) {
    if (lifted_from(i, scene.read.ball(lists.slots[at])).c <= 0) {
      sink(TupleNote::conflict, at);
      return Verdict::invalid;
    }
  }
  return Verdict::valid;
}

// Where the power is at most alpha, only neighbours of the first ball can be in conflict.
template <int N, class Reader, class Sink>
ALPHASCOPE_INLINE Verdict filter_orthosphere(const TupleInput<Reader>& scene,
                                             const NeighbourLists& lists, const BallTuple<N>& tuple,
                                             const Sink& sink) {
  const FloatCentre centre = centre_of<N>(scene, lists, tuple);
  if (!(centre.error < HUGE_VALF)) return Verdict::band;
  const Decision within = within_alpha(scene, tuple.first, centre);
  if (scene.alpha_optimisation && within == Decision::out) {
    sink(TupleNote::above_alpha);
    return Verdict::invalid;
  }
  const BallRecord i = scene.read.ball(tuple.first);
  const FloatConflict conflict(centre);
  bool unsure = within == Decision::unknown;
  const std::uint32_t end = lists.end(tuple.first);
  for (std::uint32_t at = lists.begin(tuple.first); at < end; ++at) {
    const int side = conflict.side(i, scene.read.ball(lists.slots[at]));
    if (side < 0) continue;
    if (has_place<N>(tuple, at)) continue;
    if (side > 0) {
      sink(TupleNote::conflict, at);
      return Verdict::invalid;
    }
    sink(TupleNote::unsure, at);
    unsure = true;
  }
  if (within == Decision::out) {
    sink(TupleNote::above_alpha);
    return Verdict::invalid;
  }
  return unsure ? Verdict::band : Verdict::valid;
}

// Kernel II for one tuple.
template <int N, class Reader, class Sink = NoSink>
ALPHASCOPE_INLINE Verdict filter_tuple(const TupleInput<Reader>& scene, const NeighbourLists& lists,
                                       const BallTuple<N>& tuple, const Sink& sink = {}) {
  if constexpr (N == 1) {
    return filter_vertex(scene, lists, tuple.first, sink);
  } else {
    return scene.float_holds ? filter_orthosphere<N>(scene, lists, tuple, sink) : Verdict::band;
  }
}

template <int N, class Reader>
struct FilterTuples {
  TupleInput<Reader> scene;
  NeighbourLists lists;
  const BallTuple<N>* tuples;
  Verdict* verdicts;

  ALPHASCOPE_HOST_DEVICE void operator()(std::uint64_t n) const {
    verdicts[n] = filter_tuple<N>(scene, lists, tuples[n]);
  }
};

// 1 for an item with the wanted verdict, else 0; summed up by prefix_sum().
struct HasVerdict {
  const Verdict* verdicts;
  Verdict wanted;
  ALPHASCOPE_HOST_DEVICE std::uint32_t operator()(std::uint64_t n) const {
    return verdicts[n] == wanted ? 1 : 0;
  }
};

struct FillBand {
  const Verdict* verdicts;
  const std::uint64_t* sums;
  std::uint32_t* band;
  ALPHASCOPE_HOST_DEVICE void operator()(std::uint64_t n) const {
    if (verdicts[n] == Verdict::band) band[sums[n]] = static_cast<std::uint32_t>(n);
  }
};

template <int N, class Reader>
ALPHASCOPE_INLINE LiftedSimplex<N> lifted_tuple(const TupleInput<Reader>& scene,
                                                const NeighbourLists& lists,
                                                const BallTuple<N>& tuple) {
  const BallRecord i = scene.read.ball(tuple.first);
  LiftedSimplex<N> s;
  s.weight = std::int64_t{i.radius} * i.radius;
  for (int n = 0; n < N - 1; ++n)
    s.v[n] = lifted_from(i, scene.read.ball(tuple.slot(lists, n + 1)));
  return s;
}
// Is rho <= alpha? If so, and if `rounded` is not null, *rounded becomes the float nearest to rho.
// Brackets in double precision nearly always decide; wide integers decide the rest.
template <int N>
ALPHASCOPE_INLINE bool rho_within(const LiftedSimplex<N>& s, const LatticeAlpha& alpha,
                                  float* rounded) {
  return decide_rho<ExactDecider>(s, within_bracket_limit(s), alpha, rounded) == Decision::in;
}

// Kernel III for one tuple: by the filter where it is certain, else by integers.
template <class Integer, int N, class Reader, class Sink>
ALPHASCOPE_HOST_DEVICE inline bool decide_with(const TupleInput<Reader>& scene,
                                               const NeighbourLists& lists,
                                               const BallTuple<N>& tuple, const Sink& sink) {
  const BallRecord i = scene.read.ball(tuple.first);
  const LiftedSimplex<N> simplex = lifted_tuple<N>(scene, lists, tuple);
  const ExactCentre<N - 1, Integer> exact(simplex.v);
  if (!exact.regular() || !rho_within(simplex, scene.alpha, nullptr)) {
    sink(exact.regular() ? TupleNote::above_alpha : TupleNote::flat);
    return false;
  }
  FloatCentre centre{0, 0, 0, HUGE_VALF};
  if (scene.float_holds) centre = centre_of<N>(scene, lists, tuple);
  const FloatConflict filter(centre);
  const std::uint32_t end = lists.end(tuple.first);
  for (std::uint32_t at = lists.begin(tuple.first); at < end; ++at) {
    const BallRecord m = scene.read.ball(lists.slots[at]);
    const int side = scene.float_holds ? filter.side(i, m) : 0;
    if (side < 0 || has_place<N>(tuple, at)) continue;
    if (side > 0 || exact.with(lifted_from(i, m)) != Conflict::none) {
      sink(TupleNote::conflict, at);
      return false;
    }
  }
  return true;
}
template <int N, class Reader, class Sink = NoSink>
ALPHASCOPE_INLINE Verdict decide_tuple(const TupleInput<Reader>& scene, const NeighbourLists& lists,
                                       const BallTuple<N>& tuple, const Sink& sink = {}) {
  const bool valid = scene.int128_holds ? decide_with<Int128, N>(scene, lists, tuple, sink)
                                        : decide_with<WideInt<4>, N>(scene, lists, tuple, sink);
  return valid ? Verdict::valid : Verdict::invalid;
}

// Kernel III for the tuples that kernel II left in the band.
template <int N, class Reader>
struct DecideTuples {
  TupleInput<Reader> scene;
  NeighbourLists lists;
  const BallTuple<N>* tuples;
  const std::uint32_t* band;
  Verdict* verdicts;

  ALPHASCOPE_HOST_DEVICE void operator()(std::uint64_t b) const {
    if constexpr (N > 1) {  // vertices are never in the band
      verdicts[band[b]] = decide_tuple<N>(scene, lists, tuples[band[b]]);
    }
  }
};

// Writes each valid simplex to its place: ball indices in ascending order. Also writes the alpha
// value (the float nearest to rho, square lattice units) unless `values` is null.
template <int N, class Reader>
struct EmitSimplices {
  TupleInput<Reader> scene;
  NeighbourLists lists;
  const BallTuple<N>* tuples;
  const Verdict* verdicts;
  const std::uint64_t* sums;
  std::uint32_t* simplices;  // N indices each
  float* values;
  ALPHASCOPE_HOST_DEVICE void operator()(std::uint64_t n) const {
    if (verdicts[n] != Verdict::valid) return;
    const BallTuple<N> tuple = tuples[n];
    std::uint32_t* to = simplices + sums[n] * N;
    for (int a = 0; a < N; ++a) {  // insertion sort
      const std::uint32_t ball = scene.ball[tuple.slot(lists, a)];
      int b = a;
      for (; b > 0 && to[b - 1] > ball; --b) to[b] = to[b - 1];
      to[b] = ball;
    }
    if (values == nullptr) return;
    rho_within(lifted_tuple<N>(scene, lists, tuple), scene.alpha, values + sums[n]);
  }
};

}  // namespace alphascope
