// SPDX-License-Identifier: GPL-3.0-or-later
// The tuple engine on the CPU: the executor of tuple_pipeline.hpp over oneTBB.
#include "core/tuples/tuple_engine.hpp"

#include <chrono>

#include "core/complex/count_limits.hpp"
#include "core/run/parallel.hpp"
#include "core/tuples/tuple_compute.hpp"

namespace alphascope {
namespace {

// An executor with one lane; every call has finished when it returns. Calls come from inside the
// task arena.
class CpuExecutor {
 public:
  using Reader = PlainReader;
  static constexpr bool kOnGpu = false;
  template <class T>
  class Buffer {
   public:
    void reserve(std::uint64_t count) {
      if (count <= capacity_) return;
      data_.reset();
      capacity_ = 0;
      data_ = std::make_unique_for_overwrite<T[]>(count);
      capacity_ = count;
    }
    T* get() const { return data_.get(); }

   private:
    std::unique_ptr<T[]> data_;
    std::uint64_t capacity_ = 0;
  };

  explicit CpuExecutor(const TupleOptions& options)
      : capacity_(options.tuples_per_batch > 0 ? options.tuples_per_batch : kTuplesPerBatch) {}

  void set_cancel(const CancelToken& cancel) { cancel_ = cancel; }
  std::pmr::memory_resource* host_memory() const { return std::pmr::new_delete_resource(); }
  std::uint64_t capacity() const { return capacity_; }
  std::size_t workers() const { return 1; }
  TupleUpload<PlainReader> upload(const TupleGrid& grid) const {
    return {{grid.records.data(), grid.reach.data()}, grid.cell_start.data(), grid.ball.data()};
  }

  template <class Body>
  void for_each(int, std::uint64_t count, const Body& body) const {
    // The token is read once for each range of this size.
    constexpr std::uint64_t kGrain = 64;
    if (count <= kGrain) {  // too few for other threads
      for (std::uint64_t n = 0; n < count; ++n) body(n);
      cancel_.throw_if_cancelled();
      return;
    }
    parallel_ranges(0, count, kGrain, [&](std::uint64_t first, std::uint64_t end) {
      if (cancel_.cancelled()) return;
      for (std::uint64_t n = first; n != end; ++n) body(n);
    });
    cancel_.throw_if_cancelled();
  }
  template <class Body>
  void for_each_of(int lane, const std::uint64_t* count, std::uint64_t, const Body& body) const {
    for_each(lane, *count, body);
  }
  template <class Value>
  void prefix_sum(int, std::uint64_t count, const Value& value, std::uint64_t* sums) const {
    std::uint64_t total = 0;
    for (std::uint64_t n = 0; n < count; ++n) {
      sums[n] = total;
      total += value(n);
    }
    sums[count] = total;
  }
  template <class Value>
  std::uint64_t sum(int, std::uint64_t count, const Value& value) const {
    std::uint64_t total = 0;
    for (std::uint64_t n = 0; n < count; ++n) total += value(n);
    return total;
  }
  template <class T>
  T read(int, const T* from) const {
    return *from;
  }
  template <class T>
  void fetch(int, const T* from, std::uint64_t count, ResultArray<T>& to) const {
    to.insert(to.end(), from, from + count);
  }
  void wait(int) const {}
  void reset() { times_ = {}; }

  void begin(int, std::string_view stage) {
    stage_ = stage;
    start_ = Clock::now();
  }
  void end(int) {
    // There is no device to copy from.
    if (stage_ == stage::kDeviceToHost) return;
    const double ms = std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
    for (StageTime& s : times_.stages) {
      if (s.label == stage_) {
        s.milliseconds += ms;
        return;
      }
    }
    times_.stages.push_back({std::string(stage_), ms, false});
  }
  StageTimes take_times() { return std::move(times_); }

 private:
  using Clock = std::chrono::steady_clock;
  // A batch takes a few MB and about 10 ms between two reports of progress.
  static constexpr std::uint64_t kTuplesPerBatch = std::uint64_t{1} << 18;

  const std::uint64_t capacity_;
  CancelToken cancel_;
  std::string_view stage_;
  Clock::time_point start_;
  StageTimes times_;
};

class TupleEngine : public Engine {
 public:
  TupleEngine(std::shared_ptr<const BallSet> balls, EngineOptions options, TupleOptions tuples)
      : executor_(tuples),
        computer_(std::move(balls), tuples, executor_),
        threads_(options.work_threads()) {}

  AlphaComplex compute(const AlphaRequest& request, KnownResults&,
                       const RunContext& context) override {
    AlphaComplex complex;
    executor_.set_cancel(context.cancel);
    threads_->run([&] { complex = computer_.compute(request, context); });
    complex.engine.name = "tuple engine";
    complex.engine.device = threads_->text();
    return complex;
  }

 private:
  CpuExecutor executor_;
  TupleComputer<CpuExecutor> computer_;
  std::shared_ptr<WorkThreads> threads_;
};

}  // namespace

std::vector<EngineCounter> tuple_counters(const TupleCounts& c) {
  return {{"neighbours in cubes", c.neighbours},
          {"pairs", c.pairs},
          {"triples", c.triples},
          {"4-tuples enumerated", c.tuples},
          {"4-tuples into kernel II", c.kept},
          {"4-tuples into kernel III", c.band},
          {"edges and triangles into kernel III", c.lower_band},
          {"valid 4-tuples", c.valid},
          {"batches", c.batches}};
}

std::string tuple_route(const TupleOptions& options, bool on_gpu) {
  std::string without;
  const auto add = [&](bool on, const char* name) {
    if (!on) without += (without.empty() ? ", without " : " and ") + std::string(name);
  };
  add(options.edge_optimisation, "edge optimisation");
  add(options.alpha_optimisation, "alpha optimisation");
  add(options.pinned || !on_gpu, "pinned memory");
  add(options.streams > 1 || !on_gpu, "streams");
  add(options.texture || !on_gpu, "textures");
  return (options.grid == TupleGridKind::thesis ? "tuples of neighbours, 100 x 100 x 100 grid"
                                                : "tuples of neighbours") +
         without;
}

std::unique_ptr<Engine> make_tuple_engine(std::shared_ptr<const BallSet> balls,
                                          EngineOptions options, TupleOptions tuples) {
  require_balls(balls->size());
  return std::make_unique<TupleEngine>(std::move(balls), options, tuples);
}

}  // namespace alphascope
