// SPDX-License-Identifier: GPL-3.0-or-later
// The order in which the kernels of the tuple engine run, in batches that bound its memory: balls
// with their neighbours, pairs with their triples, triples with their 4-tuples. The items of each
// batch are counted, summed up and then written. One template for both executors, which provide:
//   Reader                          of balls (tuple_input.hpp)
//   Buffer<T>                       reserve(count) (content is lost), get()
//   capacity(), workers()           tuples in a batch; lanes 1 to workers() beside lane 0
//   upload(grid) -> TupleUpload     once per run
//   for_each(lane, count, body)     body(0) to body(count - 1), in any order
//   for_each_of(lane, count, most, body)  as for_each, `count` read where the bodies run
//   prefix_sum(lane, count, value, sums)  sums[n] = value(0) + ... + value(n - 1), n = 0 to count
//   sum(lane, count, value)         waits for the lane
//   read(lane, from)                one element, waits for the lane
//   fetch(lane, from, count, to)    appended to `to` by the next wait(lane) at the latest
//   wait(lane), reset()             after a run that threw: forget the calls in progress
//   begin(lane, stage), end(lane)   time the calls in between
// Lanes run side by side; calls of one lane run in order.
#pragma once

#include <algorithm>
#include <memory>
#include <string_view>
#include <vector>

#include "core/run/cancel_token.hpp"
#include "core/tuples/tuple_body.hpp"
#include "core/tuples/tuple_closure.hpp"
#include "core/tuples/tuple_grid.hpp"

namespace alphascope {

template <class Reader>
struct TupleUpload {
  Reader read;
  const std::uint32_t* cell_start;
  const std::uint32_t* ball;
};

template <class Reader>
TupleInput<Reader> make_tuple_input(const TupleUpload<Reader>& upload, const TupleGrid& grid,
                                    const TupleOptions& options, const LatticeAlpha& alpha) {
  TupleInput<Reader> scene{};
  scene.read = upload.read;
  scene.grid = grid.view;
  scene.grid.cell_start = upload.cell_start;
  scene.ball = upload.ball;
  scene.largest_reach = grid.largest_reach;
  scene.alpha = alpha;
  scene.alpha_float = alpha.nearest_float();
  scene.edge_optimisation = options.edge_optimisation;
  scene.alpha_optimisation = options.alpha_optimisation;
  scene.alpha_covers_all = alpha.below > 1e90;  // ortho-radii are below 2^254
  scene.float_holds = grid.largest_difference < (1 << 24) && grid.largest_radius < (1 << 23);
  scene.int128_holds = grid.largest_difference < kInt128TupleOffset;
  return scene;
}

// The counts of one run. They count 4-tuples where neither the name nor the comment says otherwise.
struct TupleCounts {
  std::uint64_t neighbours = 0;  // sum over all cubes
  std::uint64_t pairs = 0, triples = 0;
  std::uint64_t tuples = 0;  // enumerated: kept by the edge optimisation
  std::uint64_t kept = 0;    // of these, kept by the alpha optimisation: into kernel II
  std::uint64_t band = 0;    // of these, into kernel III
  std::uint64_t valid = 0;
  std::uint64_t lower_band = 0;  // edges and triangles into kernel III
  std::uint64_t batches = 0;
};

struct TupleFindings {
  UnattachedSimplicesByDimension own;
  TupleCounts counts;
};

template <class Executor>
class TuplePipeline {
 public:
  explicit TuplePipeline(Executor& executor) : exec_(executor), workers_(executor.workers()) {}

  // Throws Cancelled, and any exception of the executor. The pipeline can run again after that.
  TupleFindings run(const TupleGrid& grid, const TupleOptions& options, const LatticeAlpha& alpha,
                    bool whole, const RunContext& context) {
    exec_.reset();
    for (Worker& w : workers_) w.busy = false;
    found_ = {};
    context_ = &context;
    whole_ = whole;
    ball_count_ = grid.size();
    if (ball_count_ == 0) return {};
    scene_ = make_tuple_input(exec_.upload(grid), grid, options, alpha);

    counts_.reserve(ball_count_);
    starts_.reserve(ball_count_ + 1);
    batch_end_.reserve(1);
    work(0, stage::kCandidates, ball_count_, CountNeighbours<Reader>{scene_, counts_.get()});
    add_up(0, ball_count_, counts_.get(), starts_.get());
    for (std::uint64_t first = 0; first < ball_count_;) {
      const BatchEnd end = find_batch(starts_.get(), ball_count_, first, exec_.capacity());
      ball_batch(first, end);
      found_.counts.neighbours += end.sum;
      first = end.item;
    }
    return std::move(found_);
  }

 private:
  using Reader = typename Executor::Reader;
  template <class T>
  using Buffer = typename Executor::template Buffer<T>;

  // Buffers for the tests of one batch of tuples.
  struct Test {
    Buffer<Verdict> verdicts;
    Buffer<std::uint64_t> band_sums, valid_sums;
    Buffer<std::uint32_t> band, simplices;
    Buffer<float> values;
  };
  struct Worker {
    Buffer<BallTuple<4>> tuples;
    Test test;
    std::uint64_t count = 0;
    bool busy = false;
  };

  template <class Body>
  void work(int lane, std::string_view stage, std::uint64_t count, const Body& body) {
    exec_.begin(lane, stage);
    exec_.for_each(lane, count, body);
    exec_.end(lane);
  }
  void add_up(int lane, std::uint64_t count, const std::uint32_t* counts, std::uint64_t* sums) {
    exec_.begin(lane, stage::kPrefixSum);
    exec_.prefix_sum(lane, count, ReadCount{counts}, sums);
    exec_.end(lane);
  }
  BatchEnd find_batch(const std::uint64_t* sums, std::uint64_t count, std::uint64_t first,
                      std::uint64_t capacity) {
    context_->cancel.throw_if_cancelled();
    exec_.for_each(0, 1, FindBatch{sums, count, first, capacity, batch_end_.get()});
    ++found_.counts.batches;
    return exec_.read(0, batch_end_.get());
  }
  // Reports progress: `share` of the current batch of triples is done.
  void report(double share) const {
    context_->report(stage::kCandidates, progress_ + share * (progress_end_ - progress_));
  }

  // Handles a batch of balls: neighbours, pairs, and all tuples that extend these. The lists have
  // `end.sum` places.
  void ball_batch(std::uint64_t first, const BatchEnd& end) {
    const std::uint64_t balls = end.item - first, places = end.sum;
    const auto first_slot = static_cast<std::uint32_t>(first);
    slots_.reserve(places);
    owners_.reserve(places);
    lists_ = {slots_.get(), starts_.get(), found_.counts.neighbours};
    work(0, stage::kCandidates, balls,
         FillNeighbours<Reader>{scene_, lists_, first_slot, slots_.get(), owners_.get()});
    if (whole_) {
      singles_.reserve(balls);
      work(0, stage::kCandidates, balls, FillSingles{first_slot, singles_.get()});
      test_now<1>(singles_.get(), balls, found_.own.vertices);
    }
    if (places == 0) return;

    marks_.reserve(places);
    pair_sums_.reserve(places + 1);
    work(0, stage::kCandidates, places,
         MarkPairs<Reader>{scene_, lists_, owners_.get(), marks_.get()});
    add_up(0, places, marks_.get(), pair_sums_.get());
    const std::uint64_t pairs = exec_.read(0, pair_sums_.get() + places);
    found_.counts.pairs += pairs;
    if (pairs == 0) return;
    pairs_.reserve(pairs);
    work(0, stage::kCandidates, places, FillPairs{owners_.get(), pair_sums_.get(), pairs_.get()});
    if (whole_) test_now<2>(pairs_.get(), pairs, found_.own.edges);

    triple_counts_.reserve(pairs);
    considered_.reserve(pairs);
    triple_sums_.reserve(pairs + 1);
    work(0, stage::kCandidates, pairs,
         CountExtensions<2, Reader>{scene_, lists_, pairs_.get(), triple_counts_.get(),
                                    considered_.get()});
    add_up(0, pairs, triple_counts_.get(), triple_sums_.get());
    for (std::uint64_t begin = 0; begin < pairs;) {
      const BatchEnd pair_end = find_batch(triple_sums_.get(), pairs, begin, exec_.capacity());
      const auto done = [&](std::uint64_t pairs_done) {
        return (static_cast<double>(first) + static_cast<double>(balls) *
                                                 static_cast<double>(pairs_done) /
                                                 static_cast<double>(pairs)) /
               static_cast<double>(ball_count_);
      };
      progress_ = done(begin);
      progress_end_ = done(pair_end.item);
      triple_batch(begin, pair_end);
      report(1);
      begin = pair_end.item;
    }
    drain();
  }

  // Handles a batch of pairs: their triples, and the 4-tuples that extend these.
  void triple_batch(std::uint64_t first_pair, const BatchEnd& end) {
    drain();  // the workers still read the previous triples
    const std::uint64_t triples = end.sum;
    found_.counts.triples += triples;
    if (triples == 0) return;
    triples_.reserve(triples);
    work(0, stage::kCandidates, end.item - first_pair,
         FillExtensions<2, Reader>{scene_, lists_, pairs_.get(), triple_sums_.get(), first_pair,
                                   triples_.get()});
    if (whole_) test_now<3>(triples_.get(), triples, found_.own.triangles);

    tuple_counts_.reserve(triples);
    considered_.reserve(triples);
    tuple_sums_.reserve(triples + 1);
    work(0, stage::kCandidates, triples,
         CountExtensions<3, Reader>{scene_, lists_, triples_.get(), tuple_counts_.get(),
                                    considered_.get()});
    add_up(0, triples, tuple_counts_.get(), tuple_sums_.get());
    exec_.begin(0, stage::kPrefixSum);
    found_.counts.tuples += exec_.sum(0, triples, ReadCount{considered_.get()});
    exec_.end(0);
    const std::uint64_t tuples = exec_.read(0, tuple_sums_.get() + triples);
    found_.counts.kept += tuples;
    if (tuples == 0) return;

    // Several workers share even those tuples that would fit into one batch, so that they can
    // overlap.
    const std::uint64_t shares = 2 * workers_.size();
    const std::uint64_t fair = workers_.size() == 1 ? tuples : tuples / shares + 1;
    const std::uint64_t capacity =
        std::clamp<std::uint64_t>(fair, std::min(kLeastShare, exec_.capacity()), exec_.capacity());
    std::size_t turn = 0;
    for (std::uint64_t triple = 0; triple < triples;) {
      const BatchEnd tuple_end = find_batch(tuple_sums_.get(), triples, triple, capacity);
      if (tuple_end.sum > 0) start_tuples(turn++ % workers_.size(), triple, tuple_end);
      triple = tuple_end.item;
      report(static_cast<double>(triple) / static_cast<double>(triples));
    }
  }

  void start_tuples(std::size_t turn, std::uint64_t first_triple, const BatchEnd& end) {
    finish_tuples(turn);
    Worker& w = workers_[turn];
    const int lane = static_cast<int>(turn) + 1;
    w.count = end.sum;
    w.busy = true;
    w.tuples.reserve(w.count);
    work(lane, stage::kCandidates, end.item - first_triple,
         FillExtensions<3, Reader>{scene_, lists_, triples_.get(), tuple_sums_.get(), first_triple,
                                   w.tuples.get()});
    start<4>(lane, w.test, w.tuples.get(), w.count);
  }
  void finish_tuples(std::size_t turn) {
    Worker& w = workers_[turn];
    if (!w.busy) return;
    const int lane = static_cast<int>(turn) + 1;
    finish<4>(lane, w.test, w.tuples.get(), w.count, found_.own.tetrahedra);
    exec_.wait(lane);
    w.busy = false;
  }
  void drain() {
    for (std::size_t turn = 0; turn < workers_.size(); ++turn) finish_tuples(turn);
  }

  template <int N>
  void test_now(const BallTuple<N>* tuples, std::uint64_t count, UnattachedSimplices<N>& own) {
    start<N>(0, lower_, tuples, count);
    finish<N>(0, lower_, tuples, count, own);
    exec_.wait(0);
  }

  // Starts kernels II and III, and the prefix sum for the places of valid tuples. Does not wait.
  template <int N>
  void start(int lane, Test& t, const BallTuple<N>* tuples, std::uint64_t count) {
    t.verdicts.reserve(count);
    t.band_sums.reserve(count + 1);
    t.valid_sums.reserve(count + 1);
    t.band.reserve(count);
    Verdict* verdicts = t.verdicts.get();
    work(lane, stage::kFilteredValidity, count,
         FilterTuples<N, Reader>{scene_, lists_, tuples, verdicts});
    exec_.begin(lane, stage::kPrefixSum);
    exec_.prefix_sum(lane, count, HasVerdict{verdicts, Verdict::band}, t.band_sums.get());
    exec_.for_each(lane, count, FillBand{verdicts, t.band_sums.get(), t.band.get()});
    exec_.end(lane);
    exec_.begin(lane, stage::kExactValidity);
    exec_.for_each_of(lane, t.band_sums.get() + count, count,
                      DecideTuples<N, Reader>{scene_, lists_, tuples, t.band.get(), verdicts});
    exec_.end(lane);
    exec_.begin(lane, stage::kPrefixSum);
    exec_.prefix_sum(lane, count, HasVerdict{verdicts, Verdict::valid}, t.valid_sums.get());
    exec_.end(lane);
  }

  // Writes the valid simplices and starts fetching them.
  template <int N>
  void finish(int lane, Test& t, const BallTuple<N>* tuples, std::uint64_t count,
              UnattachedSimplices<N>& own) {
    const std::uint64_t band = exec_.read(lane, t.band_sums.get() + count);
    const std::uint64_t valid = exec_.read(lane, t.valid_sums.get() + count);
    (N == 4 ? found_.counts.band : found_.counts.lower_band) += band;
    if (N == 4) found_.counts.valid += valid;
    if (valid == 0) return;
    t.simplices.reserve(valid * N);
    if (whole_) t.values.reserve(valid);
    work(lane, stage::kExactValidity, count,
         EmitSimplices<N, Reader>{scene_, lists_, tuples, t.verdicts.get(), t.valid_sums.get(),
                                  t.simplices.get(), whole_ ? t.values.get() : nullptr});
    static_assert(sizeof(std::array<BallIndex, N>) == N * sizeof(std::uint32_t));
    exec_.begin(lane, stage::kDeviceToHost);
    exec_.fetch(lane, reinterpret_cast<const std::array<BallIndex, N>*>(t.simplices.get()), valid,
                own.simplices);
    if (whole_) exec_.fetch(lane, t.values.get(), valid, own.values);
    exec_.end(lane);
  }

  // A batch of its own is worth it from this number of tuples on.
  static constexpr std::uint64_t kLeastShare = 1 << 16;

  Executor& exec_;
  std::vector<Worker> workers_;
  const RunContext* context_ = nullptr;
  bool whole_ = false;
  std::uint64_t ball_count_ = 0;
  // Progress before and after the current batch of triples.
  double progress_ = 0, progress_end_ = 0;
  TupleInput<Reader> scene_{};
  NeighbourLists lists_{};
  TupleFindings found_;

  Buffer<std::uint32_t> counts_, slots_, owners_, marks_, triple_counts_, tuple_counts_,
      considered_;
  Buffer<std::uint64_t> starts_, pair_sums_, triple_sums_, tuple_sums_;
  Buffer<BatchEnd> batch_end_;
  Buffer<BallTuple<1>> singles_;
  Buffer<BallTuple<2>> pairs_;
  Buffer<BallTuple<3>> triples_;
  Test lower_;
};

}  // namespace alphascope
