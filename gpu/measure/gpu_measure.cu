// SPDX-License-Identifier: GPL-3.0-or-later
// Measures areas and volumes on the device: memory, copies and the order of kernels.
#include "gpu/measure/gpu_measure.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/measure/exact_sum.hpp"
#include "gpu/gpu_engine.hpp"
#include "gpu/measure/measure_kernels.cuh"
#include "gpu/measure/union_measurer.hpp"
#include "gpu/memory/device_buffer.cuh"
#include "gpu/memory/handles.cuh"
#include "gpu/memory/launch.cuh"

namespace alphascope::gpu {
namespace {

using Clock = std::chrono::steady_clock;

unsigned measure_blocks(std::size_t items, int per_block) {
  return static_cast<unsigned>((items + per_block - 1) / per_block);
}

__global__ void join_balls(const LatticePoint* centres, const std::int32_t* radii,
                           std::size_t count, int4* to) {
  const std::size_t i = std::size_t{blockIdx.x} * blockDim.x + threadIdx.x;
  if (i < count) to[i] = make_int4(centres[i].x, centres[i].y, centres[i].z, radii[i]);
}

// Waits in its destructor until queued work is done, even after an exception. That work reads the
// caller's memory.
class Finished {
 public:
  explicit Finished(const Stream& stream) : stream_(stream) {}
  Finished(const Finished&) = delete;
  Finished& operator=(const Finished&) = delete;
  ~Finished() { cudaStreamSynchronize(stream_); }

 private:
  const Stream& stream_;
};

struct Lists {
  DeviceBuffer<BallIndex> vertices;
  DeviceBuffer<SimplexClass> classes;
};

}  // namespace

struct UnionMeasurer::State {
  Stream stream;
  // after[0]: before the first kernel; then after each kernel, in the order of
  // GpuMeasureTimes::kernel.
  static constexpr int kKernels = 6;
  Event upload_begin, upload_end, after[kKernels + 1], downloaded;
  bool uploaded = false;  // since the last measurement
  // The uploaded complex.
  DeviceBuffer<LatticePoint> centres;
  DeviceBuffer<std::int32_t> radii;
  DeviceBuffer<int4> joined;
  Lists lists[4];
  // Buffers of a measurement.
  DeviceBuffer<GrownBall> grown;
  DeviceBuffer<QuantityValues> scales;
  DeviceBuffer<QuantitySums> sums;
  DeviceBuffer<EdgeRow> rows;
  DeviceBuffer<std::uint8_t> open;
  DeviceBuffer<double> result;  // each quantity of all balls, then sums of blocks
  PinnedBuffer<double> host;

  template <class T>
  void send(DeviceBuffer<T>& to, const T* from, std::size_t count) {
    if (count == 0) return;
    to.reserve(count);
    check(cudaMemcpyAsync(to.get(), from, count * sizeof(T), cudaMemcpyHostToDevice, stream),
          "copying the complex");
  }
  template <int N>
  DeviceSimplices send(const SimplexList<N>& list) {
    static_assert(sizeof(std::array<BallIndex, N>) == N * sizeof(BallIndex));
    Lists& to = lists[N - 1];
    const std::size_t count = list.size();
    if (count > 0) send(to.vertices, list.simplices[0].data(), N * count);
    if (N < 4) send(to.classes, list.classes.data(), count);
    return {to.vertices.get(), to.classes.get(), count};
  }

  MeasureInput scene(std::size_t balls) {
    grown.reserve(balls);
    scales.reserve(balls);
    sums.reserve(balls);
    rows.reserve(balls);
    open.reserve(balls);
    return {grown.get(), scales.get(), sums.get(), rows.get(), open.get()};
  }
  template <class Kernel, class... Arguments>
  void each(Kernel kernel, std::size_t items, int per_block, const Arguments&... arguments) {
    if (items == 0) return;
    launch(kernel, {measure_blocks(items, per_block), kMeasureThreads, stream}, arguments...);
    check(cudaGetLastError(), "starting a kernel");
  }
  void enqueue(const DeviceComplex& complex);
  HostMeasures result_of(const DeviceComplex& complex) const;
  void add_times_to(GpuMeasureTimes& times, bool with_upload) const;
};

UnionMeasurer::UnionMeasurer() : state_(std::make_unique<State>()) {
  State& s = *state_;
  s.stream.create();
  for (Event* e : {&s.upload_begin, &s.upload_end, &s.downloaded}) e->create(cudaEventDefault);
  for (Event& e : s.after) e.create(cudaEventDefault);
}
// Waits, because queued work uses memory that is about to be freed.
UnionMeasurer::~UnionMeasurer() {
  cudaStreamSynchronize(state_->stream);
}

DeviceComplex UnionMeasurer::upload(const BallSet& balls, const AlphaComplex& complex,
                                    const CancelToken& cancel) {
  State& s = *state_;
  cancel.throw_if_cancelled();
  const std::size_t n = balls.size();
  s.uploaded = true;
  const Finished finished(s.stream);
  s.upload_begin.record(s.stream);
  s.send(s.centres, balls.centres.data(), n);
  s.send(s.radii, balls.radii.data(), n);
  s.joined.reserve(n);
  s.each(join_balls, n, kMeasureThreads, s.centres.get(), s.radii.get(), n, s.joined.get());
  DeviceComplex on_device;
  on_device.lattice = complex.lattice;
  on_device.alpha_on_lattice = complex.alpha_on_lattice;
  on_device.balls = reinterpret_cast<const std::int32_t*>(s.joined.get());
  on_device.ball_count = n;
  on_device.vertices = s.send(complex.vertices);
  on_device.edges = s.send(complex.edges);
  on_device.triangles = s.send(complex.triangles);
  on_device.tetrahedra = s.send(complex.tetrahedra);
  s.upload_end.record(s.stream);
  check(cudaStreamSynchronize(s.stream), "copying the complex");
  return on_device;
}

void UnionMeasurer::State::enqueue(const DeviceComplex& complex) {
  const std::size_t n = complex.ball_count;
  const std::size_t numbers = kMeasuredQuantities * (n + measure_blocks(n, kMeasureThreads));
  const MeasureInput by_ball = scene(n);
  result.reserve(numbers);
  host.reserve(numbers);
  int kernels = 0;
  const auto then = [&](auto kernel, std::size_t items, int per_block, const auto&... arguments) {
    each(kernel, items, per_block, arguments...);
    after[++kernels].record(stream);
  };
  MeasureOutput out = {{}, result.get() + kMeasuredQuantities * n, complex.lattice.unit_angstrom()};
  each_quantity(
      [&](MeasuredQuantity q) { out.of_ball[q] = result.get() + static_cast<int>(q) * n; });
  after[0].record(stream);
  then(prepare_balls, n, kMeasureThreads, complex, by_ball);
  then(add_vertices, complex.vertices.count, kMeasureThreads, complex.vertices, by_ball);
  then(add_edges, complex.edges.count, kMeasureThreads, complex.edges, by_ball);
  then(add_triangles, complex.triangles.count, kMeasurePart, complex.triangles, by_ball);
  then(add_tetrahedra, complex.tetrahedra.count, kMeasurePart, complex.tetrahedra, complex.edges,
       by_ball);
  then(write_measures, n, kMeasureThreads, n, by_ball, out);
  check(cudaMemcpyAsync(host.get(), result.get(), numbers * sizeof(double), cudaMemcpyDeviceToHost,
                        stream),
        "copying areas and volumes");
  downloaded.record(stream);
}

HostMeasures UnionMeasurer::State::result_of(const DeviceComplex& complex) const {
  const std::size_t n = complex.ball_count, blocks = measure_blocks(n, kMeasureThreads);
  const double* of_block = host.get() + kMeasuredQuantities * n;
  HostMeasures measures;
  each_quantity([&](MeasuredQuantity q) {
    const int at = static_cast<int>(q);
    NeumaierSum sum;
    for (std::size_t b = 0; b < blocks; ++b) sum.add(of_block[kMeasuredQuantities * b + at]);
    measures.total[q] = sum.value();
    measures.of_ball[q] = {host.get() + at * n, n};
  });
  return measures;
}

void UnionMeasurer::State::add_times_to(GpuMeasureTimes& times, bool with_upload) const {
  const auto between = [](const Event& from, const Event& to) {
    float milliseconds = 0;
    check(cudaEventElapsedTime(&milliseconds, from, to), "reading an event");
    return static_cast<double>(milliseconds);
  };
  for (int k = 0; k < kKernels; ++k) times.kernel[k] = between(after[k], after[k + 1]);
  times.kernels = between(after[0], after[kKernels]);
  times.download = between(after[kKernels], downloaded);
  times.upload = with_upload ? between(upload_begin, upload_end) : 0;
}

HostMeasures UnionMeasurer::measure(const DeviceComplex& complex, const CancelToken& cancel,
                                    GpuMeasureTimes* times) {
  State& s = *state_;
  cancel.throw_if_cancelled();
  const bool uploaded = std::exchange(s.uploaded, false);
  if (complex.ball_count == 0) return {};
  const auto start = Clock::now();
  s.enqueue(complex);
  check(cudaStreamSynchronize(s.stream), "measuring");
  const HostMeasures measures = s.result_of(complex);
  if (times != nullptr) {
    s.add_times_to(*times, uploaded);
    times->whole = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  }
  return measures;
}

}  // namespace alphascope::gpu

namespace alphascope {
namespace {

class CudaMeasurer : public GpuMeasurer {
 public:
  void measure(const BallSet& balls, const AlphaComplex& complex, UnionMeasures& to,
               const RunContext& context, GpuMeasureTimes* times) override {
    require_same_balls(balls, complex);
    const auto start = gpu::Clock::now();
    const gpu::DeviceComplex on_device = measurer_.upload(balls, complex, context.cancel);
    measurer_.measure(on_device, context.cancel, times).copy_to(to);
    if (times != nullptr) {
      times->whole = std::chrono::duration<double, std::milli>(gpu::Clock::now() - start).count();
    }
  }

 private:
  gpu::UnionMeasurer measurer_;
};

}  // namespace

std::unique_ptr<GpuMeasurer> make_gpu_measurer(std::string* why_not) {
  const GpuDevice& device = gpu_device();
  std::string reason = device.why_not;
  if (device.usable) {
    try {
      return std::make_unique<CudaMeasurer>();
    } catch (const std::exception& error) {
      reason = device.name + " cannot be used: " + error.what();
    }
  }
  if (why_not != nullptr) *why_not = reason;
  return nullptr;
}

}  // namespace alphascope
