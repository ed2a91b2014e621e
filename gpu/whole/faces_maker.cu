// SPDX-License-Identifier: GPL-3.0-or-later
// Memory, copies and the order of kernels of FacesMaker. A finished array travels to the host while
// the next is made.
#include "gpu/whole/faces_maker.hpp"

#include <thrust/iterator/counting_iterator.h>
#include <thrust/iterator/transform_iterator.h>
#include <cub/device/device_reduce.cuh>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "core/complex/simplex_count.hpp"
#include "core/complex/triangulation.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/run/parallel.hpp"
#include "core/run/stage_timer.hpp"
#include "gpu/memory/device_buffer.cuh"
#include "gpu/memory/prefix_sum.cuh"
#include "gpu/memory/result_memory.cuh"
#include "gpu/memory/work_stream.cuh"
#include "gpu/whole/edges.cuh"
#include "gpu/whole/membership.cuh"
#include "gpu/whole/outside.cuh"
#include "gpu/whole/steps.cuh"
#include "gpu/whole/tetrahedra.cuh"

namespace alphascope::gpu {
namespace {

// A list by balls is put in order by comparing each record with all of its ball. With more
// comparisons than these the CPU is faster: a ball has very many neighbours.
constexpr std::uint64_t kMostComparisons = std::uint64_t{1} << 36;
// Numbers of faces are 32-bit, of which the sums of CUB use 31.
constexpr std::uint64_t kMostListedTriangles = std::uint64_t{1} << 29;
// Rounds of the flow between two looks at whether it goes on.
constexpr int kFlowRoundsAtOnce = 16;
constexpr std::size_t kMostSample = 4096;  // sample_stride() leaves fewer

struct SquareOf {
  const std::uint32_t* counts;
  __device__ std::uint64_t operator()(std::uint32_t n) const {
    return std::uint64_t{counts[n]} * counts[n];
  }
};

// Places of arrays in one piece of memory.
class Layout {
 public:
  template <class T>
  std::size_t add(std::size_t count) {
    constexpr std::size_t kAlign = 256;
    const std::size_t at = bytes_;
    arrays_.push_back({at, count * sizeof(T)});
    bytes_ += (count * sizeof(T) + kAlign - 1) / kAlign * kAlign;
    return at;
  }
  std::size_t bytes() const { return bytes_; }

  struct Array {
    std::size_t at, bytes;
  };
  const std::vector<Array>& arrays() const { return arrays_; }

 private:
  std::size_t bytes_ = 0;
  std::vector<Array> arrays_;
};

// Where the values of the faces of one dimension lie.
struct ValuesAt {
  std::size_t value, regular_from, interior_from, classes, count;
  ValuesAt(Layout& layout, std::size_t faces)
      : value(layout.add<float>(faces)),
        regular_from(layout.add<float>(faces)),
        interior_from(layout.add<float>(faces)),
        classes(layout.add<SimplexClass>(faces)),
        count(faces) {}
};

// Results that travel to the host, in the same places there and here.
struct FiltrationLayout : Layout {
  std::size_t triangles, edges, tetrahedron_values;
  ValuesAt of_triangles, of_edges, of_vertices;
  explicit FiltrationLayout(const SimplexCount& count)
      : triangles(add<std::array<BallIndex, 3>>(count.triangles)),
        edges(add<std::array<BallIndex, 2>>(count.edges)),
        tetrahedron_values(add<float>(count.tetrahedra)),
        of_triangles(*this, count.triangles),
        of_edges(*this, count.edges),
        of_vertices(*this, count.vertices) {}
};
struct MembershipLayout : Layout {
  std::size_t tetrahedra, triangles, edges, vertices;
  MembershipLayout(const SimplexCount& count, std::size_t balls)
      : tetrahedra(add<std::uint8_t>(count.tetrahedra)),
        triangles(add<std::uint8_t>(count.triangles)),
        edges(add<std::uint8_t>(count.edges)),
        vertices(add<std::uint8_t>(balls)) {}
};
struct GroundLayout : Layout {
  std::size_t triangles, edges, of_tetrahedron, tetrahedra, of_triangle, marks, values;
  explicit GroundLayout(const SimplexCount& count)
      : triangles(add<std::array<BallIndex, 3>>(count.triangles)),
        edges(add<std::array<BallIndex, 2>>(count.edges)),
        of_tetrahedron(add<std::array<std::uint32_t, 4>>(count.tetrahedra)),
        tetrahedra(add<std::array<std::uint32_t, 2>>(count.triangles)),
        of_triangle(add<std::array<std::uint32_t, 3>>(count.triangles)),
        marks(add<std::uint8_t>(count.tetrahedra)),
        values(add<float>(count.tetrahedra)) {}
};

// Results keep their memory. This lets go of it in any case, so that a cancelled call keeps none.
struct LetGoAtEnd {
  std::shared_ptr<unsigned char>& memory;
  ~LetGoAtEnd() { memory.reset(); }
};

}  // namespace

struct FacesMaker::State {
  WorkStream stream, copier;
  Event made;
  PinnedBuffer<int4> host_balls;
  DeviceBuffer<int4> balls;
  DeviceBuffer<uint4> tetrahedra, neighbours;
  DeviceBuffer<BallIndex> vertices;
  DeviceBuffer<std::uint32_t> of_ball, first, first_edge, placed, lower, higher, numbers;
  DeviceBuffer<std::uint64_t> rest, sums;
  DeviceBuffer<FaceCode> record_codes, codes;
  DeviceBuffer<std::uint8_t> names_edges, is_new, attached, attached_balls, marks;
  DeviceBuffer<Told> told, told_balls;
  DeviceBuffer<float> samples;
  DeviceBuffer<StepValues> steps;
  DeviceBuffer<unsigned char> result, in_complex, scratch;
  DeviceBuffer<std::uint32_t> chosen;
  DeviceBuffer<OutsidePart> parts;
  // On the host; they are also in `result` and `in_complex`.
  std::weak_ptr<unsigned char> last_ground, last_membership;
  MembershipAt last_at{};
  PinnedBuffer<std::uint64_t> host_sums;
  PinnedBuffer<std::uint32_t> host_numbers;
  PinnedBuffer<float> host_samples;
  PinnedBuffer<StepValues> host_steps;
  std::shared_ptr<ResultMemory> results = std::make_shared<ResultMemory>();

  WholeTriangulation in{};
  SimplexCount count;
  std::shared_ptr<unsigned char> to_host;

  State() {
    stream.create();
    copier.create();
    made.create(cudaEventDisableTiming);
  }

  // Begins with a triangulation: queues its way to the device, and makes room for the results.
  bool begin(const BallSet& of, const Triangulation& triangulation,
             const TriangulationOnDevice& there, const Layout& layout, std::string& why_not) {
    count = simplex_count(triangulation);
    if (count.triangles > kMostListedTriangles) {
      why_not = "more simplices than the device can number";
      return false;
    }
    send_balls(of);
    const std::size_t t = count.tetrahedra;
    in = {balls.get(),
          static_cast<const uint4*>(there.tetrahedra),
          static_cast<const uint4*>(there.neighbours),
          static_cast<std::uint32_t>(of.size()),
          static_cast<std::uint32_t>(t),
          static_cast<std::uint32_t>(count.triangles),
          static_cast<std::uint32_t>(count.edges),
          static_cast<std::uint32_t>(count.vertices)};
    if (there.tetrahedra == nullptr) {
      tetrahedra.reserve(t);
      neighbours.reserve(t);
      stream.send(tetrahedra, triangulation.tetrahedra.data(), t);
      stream.send(neighbours, triangulation.neighbours.data(), t);
      in.tetrahedra = tetrahedra.get();
      in.neighbours = neighbours.get();
    }
    numbers.reserve(2);
    host_numbers.reserve(3);
    forget_ground();
    result.reserve(layout.bytes());
    to_host = results->take(layout.bytes()).memory;
    return true;
  }
  void send_balls(const BallSet& of) {
    balls.reserve(of.size());
    host_balls.reserve(of.size());
    int4* const to = host_balls.get();
    parallel_many(of.size(), {}, [&](std::size_t n) {
      const LatticePoint& p = of.centres[n];
      to[n] = make_int4(p.x, p.y, p.z, of.radii[n]);
    });
    stream.send(balls, to, of.size());
  }

  template <class T>
  T* at(std::size_t place) const {
    return reinterpret_cast<T*>(result.get() + place);
  }
  FaceValues values_at(const ValuesAt& of) const {
    return {at<float>(of.value), at<float>(of.regular_from), at<float>(of.interior_from),
            at<SimplexClass>(of.classes)};
  }
  // After all work. The number of edges follows from that of the others by Euler's formula.
  void require_all_edges() const {
    if (host_numbers.get()[2] != in.edge_count)
      throw DeviceError("the GPU found a wrong number of edges");
  }
  void forget_ground() {
    last_ground = {};
    last_membership = {};
  }
  // Queues the way of finished arrays to the host: those that lie from `from` to `end`.
  void bring(const Layout& layout, std::size_t from, std::size_t end) {
    made.record(stream);
    made.make_wait(copier);
    for (const Layout::Array& array : layout.arrays()) {
      if (array.at >= from && array.at < end && array.bytes > 0)
        copier.fetch(to_host.get() + array.at, result.get() + array.at, array.bytes);
    }
  }
  template <class T>
  ResultArray<T> array(std::size_t place, std::size_t size) const {
    return in_place(to_host, std::span<T>{reinterpret_cast<T*>(to_host.get() + place), size});
  }

  void find_values_and_flow(FlowTies ties, float* values, std::uint8_t* to_marks) {
    stream.fill(numbers, 0, 2);
    stream.each(find_flow, count.tetrahedra, in, ties, values, to_marks, numbers.get());
  }

  // Waits for the sum of the squares of the numbers in `of_ball`.
  bool are_lists_short(std::string& why_not) {
    sums.reserve(1);
    host_sums.reserve(1);
    const auto squares = thrust::make_transform_iterator(
        thrust::make_counting_iterator(std::uint32_t{0}), SquareOf{of_ball.get()});
    const auto run = [&](void* memory, std::size_t& bytes) {
      check(cub::DeviceReduce::Sum(memory, bytes, squares, sums.get(),
                                   static_cast<int>(in.ball_count), stream),
            "a sum");
    };
    std::size_t bytes = 0;
    run(nullptr, bytes);
    scratch.reserve(bytes);
    run(scratch.get(), bytes);
    stream.fetch(host_sums.get(), sums.get(), 1);
    stream.wait("counting faces");
    if (*host_sums.get() <= kMostComparisons) return true;
    why_not = "some balls have too many neighbours for the device";
    return false;
  }
  void sum_up(const DeviceBuffer<std::uint32_t>& to) {
    prefix_sum(of_ball.get(), to.get(), in.ball_count + 1, scratch, stream);
  }

  // The codes of all triangles in their order.
  bool list_triangles(std::string& why_not) {
    const std::size_t n = in.ball_count + 1;
    of_ball.reserve(n);
    first.reserve(n);
    placed.reserve(n);
    rest.reserve(count.triangles);
    record_codes.reserve(count.triangles);
    codes.reserve(count.triangles);
    stream.fill(of_ball, 0, n);
    stream.fill(placed, 0, n);
    stream.each(count_triangles, count.tetrahedra, in, of_ball.get());
    sum_up(first);
    if (!are_lists_short(why_not)) return false;
    const TriangleRecords records{first.get(), rest.get(), record_codes.get()};
    stream.each(record_triangles, count.tetrahedra, in, records, placed.get());
    stream.each(rank_triangles, count.triangles, in, records, codes.get());
    return true;
  }
  void set_all_triangles(Triangles& to, const float* values) {
    names_edges.reserve(count.triangles);
    to.names_edges = names_edges.get();
    stream.fill(of_ball, 0, in.ball_count + 1);
    stream.each(set_triangles, count.triangles, in, codes.get(), values, marks.get(), to,
                of_ball.get());
  }
  // After set_all_triangles(). Each edge has at most half as many names as triangles around it.
  bool list_edges(const Triangles& triangles, uint2* edges, std::string& why_not) {
    const std::size_t n = in.ball_count + 1, names = count.triangles + count.triangles / 2 + 1;
    first_edge.reserve(n);
    lower.reserve(names);
    higher.reserve(names);
    is_new.reserve(names);
    sum_up(first);
    if (!are_lists_short(why_not)) return false;
    const EdgeNames all{first.get(), lower.get(), higher.get(), is_new.get()};
    stream.fill(placed, 0, n);
    stream.fill(of_ball, 0, n);
    stream.each(name_edges, count.triangles, in.triangle_count, triangles, all, placed.get());
    stream.each(find_new_names, names, in.ball_count, all, of_ball.get());
    sum_up(first_edge);
    stream.each(rank_edges, names, in, all, first_edge.get(), edges);
    stream.fetch(host_numbers.get() + 2, first_edge.get() + in.ball_count, 1);
    return true;
  }

  void spread_flow(std::uint8_t* of, const CancelToken& cancel) {
    stream.each(mark_ends, count.tetrahedra, in, of);
    do {
      cancel.throw_if_cancelled();
      check(cudaMemsetAsync(numbers.get() + 1, 0, sizeof(std::uint32_t), stream),
            "clearing device memory");
      for (int round = 0; round < kFlowRoundsAtOnce; ++round)
        stream.each(spread_ends, count.tetrahedra, in, of, numbers.get() + 1);
      stream.fetch(host_numbers.get(), numbers.get(), 2);
      stream.wait("following the flow");
    } while (host_numbers.get()[1] != 0);
  }

  void set_all_edges(const Triangles& triangles, const uint2* edges, const FaceValues& of_edges) {
    told.reserve(count.edges);
    attached.reserve(count.edges);
    told_balls.reserve(in.ball_count);
    attached_balls.reserve(in.ball_count);
    stream.each(forget_told, count.edges, told.get(), in.edge_count);
    stream.each(forget_told, in.ball_count, told_balls.get(), in.ball_count);
    stream.fill(attached, 0, count.edges);
    stream.fill(attached_balls, 0, in.ball_count);
    stream.each(tell_edges, count.triangles, in, triangles, first_edge.get(), edges, told.get(),
                attached.get());
    stream.each(set_edges, count.edges, in, edges, told.get(), attached.get(), of_edges,
                told_balls.get(), attached_balls.get());
  }
  void set_all_vertices(const std::vector<BallIndex>& of, const FaceValues& to) {
    vertices.reserve(of.size());
    stream.send(vertices, of.data(), of.size());
    stream.each(set_vertices, count.vertices, in, vertices.get(), told_balls.get(),
                attached_balls.get(), to);
  }

  // Values of one dimension, and its simplices.
  struct Listed {
    const std::uint32_t* simplices;
    const float* values;
    std::size_t count;
  };
  template <int N>
  void sum_listed(const Listed& of) {
    if (of.count == 0) return;
    constexpr unsigned kBlocks = 1024;
    const auto blocks =
        static_cast<unsigned>(std::min<std::size_t>(kBlocks, (of.count + 255) / 256));
    launch(sum_steps<N>, {blocks, kStepThreads, stream}, of.simplices, of.values,
           static_cast<std::uint32_t>(of.count), steps.get() + (N - 1),
           reinterpret_cast<unsigned long long*>(sums.get()) + (N - 1) * StepSums().size());
    check(cudaGetLastError(), "starting a kernel");
  }
  HashStepsByDimension hash_steps(const std::array<Listed, 4>& lists) {
    constexpr std::size_t kSums = 4 * StepSums().size();
    samples.reserve(4 * kMostSample);
    host_samples.reserve(4 * kMostSample);
    steps.reserve(4);
    host_steps.reserve(4);
    sums.reserve(kSums);
    host_sums.reserve(kSums);
    std::array<std::size_t, 4> size{};
    stream.fill(samples, 0, 4 * kMostSample);
    for (std::size_t d = 0; d < 4; ++d) {
      const std::size_t stride = sample_stride(lists[d].count);
      size[d] = (lists[d].count + stride - 1) / stride;
      stream.each(gather_sample, size[d], lists[d].values,
                  static_cast<std::uint32_t>(lists[d].count), static_cast<std::uint32_t>(stride),
                  samples.get() + d * kMostSample);
    }
    stream.fetch(host_samples.get(), samples.get(), 4 * kMostSample);
    stream.wait("values of a filtration");
    for (std::size_t d = 0; d < 4; ++d) {
      const float* const of = host_samples.get() + d * kMostSample;
      host_steps.get()[d] = step_values(std::vector<float>(of, of + size[d]));
    }
    stream.send(steps, host_steps.get(), 4);
    stream.fill(sums, 0, kSums);
    sum_listed<1>(lists[0]);
    sum_listed<2>(lists[1]);
    sum_listed<3>(lists[2]);
    sum_listed<4>(lists[3]);
    stream.fetch(host_sums.get(), sums.get(), kSums);
    stream.wait("hashing a filtration");
    const auto made_of = [&](std::size_t d) {
      if (lists[d].count == 0) return HashSteps();
      StepSums own;
      std::copy_n(host_sums.get() + d * own.size(), own.size(), own.begin());
      return HashSteps(host_steps.get()[d], own);
    };
    HashStepsByDimension all;
    all.vertices = made_of(0);
    all.edges = made_of(1);
    all.triangles = made_of(2);
    all.tetrahedra = made_of(3);
    return all;
  }
};

FacesMaker::FacesMaker() : state_(std::make_unique<State>()) {}

// Waits, because queued work uses memory that is about to be freed.
FacesMaker::~FacesMaker() {
  cudaStreamSynchronize(state_->stream);
  cudaStreamSynchronize(state_->copier);
  state_->results->close();
}

std::optional<FiltrationParts> FacesMaker::filtration_parts(const BallSet& balls,
                                                            const Triangulation& triangulation,
                                                            const TriangulationOnDevice& there,
                                                            const RunContext& context,
                                                            std::string& why_not) {
  State& s = *state_;
  const CancelToken& cancel = context.cancel;
  context.report(stage::kClassification, 0);
  const FiltrationLayout layout(simplex_count(triangulation));
  const LetGoAtEnd lets_go{s.to_host};
  const WaitAtEnd waits{s.stream, s.copier};
  if (!s.begin(balls, triangulation, there, layout, why_not)) return std::nullopt;
  s.marks.reserve(s.count.tetrahedra);
  float* const tetrahedron_values = s.at<float>(layout.tetrahedron_values);
  s.find_values_and_flow(FlowTies::strict, tetrahedron_values, s.marks.get());
  if (!s.list_triangles(why_not)) return std::nullopt;
  cancel.throw_if_cancelled();
  Triangles triangles{};
  triangles.balls = s.at<std::uint32_t>(layout.triangles);
  triangles.values = s.values_at(layout.of_triangles);
  s.set_all_triangles(triangles, tetrahedron_values);
  s.bring(layout, layout.triangles, layout.edges);
  s.bring(layout, layout.tetrahedron_values, layout.of_edges.value);
  uint2* const edges = s.at<uint2>(layout.edges);
  if (!s.list_edges(triangles, edges, why_not)) return std::nullopt;
  cancel.throw_if_cancelled();
  context.report(stage::kClassification, 0.5);
  s.set_all_edges(triangles, edges, s.values_at(layout.of_edges));
  s.bring(layout, layout.edges, layout.tetrahedron_values);
  s.bring(layout, layout.of_edges.value, layout.of_vertices.value);
  s.set_all_vertices(triangulation.vertices, s.values_at(layout.of_vertices));
  s.bring(layout, layout.of_vertices.value, layout.bytes());
  FiltrationParts parts;
  parts.hash_steps = s.hash_steps(
      {{{s.vertices.get(), s.at<float>(layout.of_vertices.value), s.count.vertices},
        {s.at<std::uint32_t>(layout.edges), s.at<float>(layout.of_edges.value), s.count.edges},
        {triangles.balls, triangles.values.value, s.count.triangles},
        {reinterpret_cast<const std::uint32_t*>(s.in.tetrahedra), tetrahedron_values,
         s.count.tetrahedra}}});
  s.copier.wait("copying a filtration");
  s.require_all_edges();
  cancel.throw_if_cancelled();
  const auto take = [&](const ValuesAt& from, auto& list, ClassLevels& levels) {
    list.alpha_values = s.array<float>(from.value, from.count);
    list.classes = s.array<SimplexClass>(from.classes, from.count);
    levels.regular_from = s.array<float>(from.regular_from, from.count);
    levels.interior_from = s.array<float>(from.interior_from, from.count);
  };
  parts.triangles.simplices =
      s.array<std::array<BallIndex, 3>>(layout.triangles, s.count.triangles);
  parts.edges.simplices = s.array<std::array<BallIndex, 2>>(layout.edges, s.count.edges);
  parts.tetrahedron_values = s.array<float>(layout.tetrahedron_values, s.count.tetrahedra);
  take(layout.of_triangles, parts.triangles, parts.levels.triangles);
  take(layout.of_edges, parts.edges, parts.levels.edges);
  take(layout.of_vertices, parts.vertices, parts.levels.vertices);
  return parts;
}

std::optional<TriangulationGround> FacesMaker::ground(const BallSet& balls,
                                                      const Triangulation& triangulation,
                                                      const TriangulationOnDevice& there,
                                                      FlowTies ties, const RunContext& context,
                                                      std::string& why_not) {
  State& s = *state_;
  const CancelToken& cancel = context.cancel;
  context.report(stage::kFlow, 0);
  const GroundLayout layout(simplex_count(triangulation));
  const LetGoAtEnd lets_go{s.to_host};
  const WaitAtEnd waits{s.stream, s.copier};
  if (!s.begin(balls, triangulation, there, layout, why_not)) return std::nullopt;
  std::uint8_t* const marks = s.at<std::uint8_t>(layout.marks);
  s.find_values_and_flow(ties, s.at<float>(layout.values), marks);
  if (!s.list_triangles(why_not)) return std::nullopt;
  cancel.throw_if_cancelled();
  Triangles triangles{};
  triangles.balls = s.at<std::uint32_t>(layout.triangles);
  triangles.tetrahedra = s.at<uint2>(layout.tetrahedra);
  triangles.of_tetrahedron = s.at<std::uint32_t>(layout.of_tetrahedron);
  s.set_all_triangles(triangles, nullptr);
  s.bring(layout, layout.triangles, layout.edges);
  s.bring(layout, layout.of_tetrahedron, layout.of_triangle);
  uint2* const edges = s.at<uint2>(layout.edges);
  if (!s.list_edges(triangles, edges, why_not)) return std::nullopt;
  cancel.throw_if_cancelled();
  context.report(stage::kFlow, 0.5);
  s.stream.each(find_edges_of_triangles, 3 * s.count.triangles, s.in.triangle_count,
                triangles.balls, s.first_edge.get(), edges,
                s.at<std::uint32_t>(layout.of_triangle));
  s.bring(layout, layout.edges, layout.of_tetrahedron);
  s.bring(layout, layout.of_triangle, layout.marks);
  s.spread_flow(marks, cancel);
  s.bring(layout, layout.marks, layout.bytes());
  s.copier.wait("copying incidences");
  s.require_all_edges();
  cancel.throw_if_cancelled();
  TriangulationGround ground;
  Incidence& to = ground.incidence;
  to.triangles = s.array<std::array<BallIndex, 3>>(layout.triangles, s.count.triangles);
  to.edges = s.array<std::array<BallIndex, 2>>(layout.edges, s.count.edges);
  to.triangles_of_tetrahedron =
      s.array<std::array<std::uint32_t, 4>>(layout.of_tetrahedron, s.count.tetrahedra);
  to.tetrahedra_of_triangle =
      s.array<std::array<std::uint32_t, 2>>(layout.tetrahedra, s.count.triangles);
  to.edges_of_triangle =
      s.array<std::array<std::uint32_t, 3>>(layout.of_triangle, s.count.triangles);
  ground.flow.marks = s.array<std::uint8_t>(layout.marks, s.count.tetrahedra);
  ground.flow.alpha_values = s.array<float>(layout.values, s.count.tetrahedra);
  ground.flow.ties = s.host_numbers.get()[0];
  s.last_ground = s.to_host;
  return ground;
}

void FacesMaker::forget_ground() {
  state_->forget_ground();
}

std::optional<Membership> FacesMaker::membership(const Incidence& incidence,
                                                 const LatticeAlpha& alpha,
                                                 const CancelToken& cancel) {
  State& s = *state_;
  const GroundLayout ground(s.count);
  const std::shared_ptr<unsigned char> last = s.last_ground.lock();
  if (!last || incidence.triangles.data()->data() !=
                   reinterpret_cast<const BallIndex*>(last.get() + ground.triangles))
    return std::nullopt;
  s.last_membership = {};
  const MembershipLayout layout(s.count, s.in.ball_count);
  const LetGoAtEnd lets_go{s.to_host};
  const WaitAtEnd waits{s.stream, s.copier};
  s.in_complex.reserve(layout.bytes());
  s.attached_balls.reserve(s.in.ball_count);
  s.to_host = s.results->take(layout.bytes()).memory;
  unsigned char* const marks = s.in_complex.get();
  const MembershipAt at{s.in,
                        s.at<float>(ground.values),
                        s.at<std::uint8_t>(ground.marks),
                        s.at<std::uint32_t>(ground.triangles),
                        s.at<uint2>(ground.edges),
                        s.at<std::uint32_t>(ground.of_tetrahedron),
                        s.at<uint2>(ground.tetrahedra),
                        s.at<std::uint32_t>(ground.of_triangle),
                        alpha,
                        alpha.nearest_float(),
                        marks + layout.tetrahedra,
                        marks + layout.triangles,
                        marks + layout.edges,
                        marks + layout.vertices,
                        s.attached_balls.get()};
  const SimplexCount& n = s.count;
  const std::size_t balls = s.in.ball_count;
  s.stream.fill(s.in_complex, 0, layout.bytes());
  s.stream.fill(s.attached_balls, 0, balls);
  s.stream.each(mark_tetrahedra, n.tetrahedra, at);
  s.stream.each(mark_triangles, n.triangles, at);
  s.stream.each(ask_edges, n.edges, at);
  s.stream.each(leave_out_attached_edges, n.triangles, at);
  s.stream.each(mark_edges, n.edges, at);
  s.stream.each(ask_vertices, balls, at);
  s.stream.each(leave_out_attached_vertices, n.edges, at);
  s.stream.each(mark_vertices_in, balls, at);
  s.stream.fetch(s.to_host.get(), marks, layout.bytes());  // all of it was cleared
  s.stream.wait("finding what is in the complex");
  cancel.throw_if_cancelled();
  Membership in;
  in.tetrahedra = s.array<std::uint8_t>(layout.tetrahedra, n.tetrahedra);
  in.triangles = s.array<std::uint8_t>(layout.triangles, n.triangles);
  in.edges = s.array<std::uint8_t>(layout.edges, n.edges);
  in.vertices = s.array<std::uint8_t>(layout.vertices, balls);
  s.last_membership = s.to_host;
  s.last_at = at;
  return in;
}

std::optional<ResultArray<OutsidePart>> FacesMaker::outside_parts(
    const Membership& in, std::span<const std::uint32_t> tetrahedra, double solvent,
    const CancelToken& cancel) {
  State& s = *state_;
  const std::shared_ptr<unsigned char> last = s.last_membership.lock();
  if (!last || in.tetrahedra.data() != last.get()) return std::nullopt;
  const std::size_t count = tetrahedra.size();
  const WaitAtEnd waits{s.stream, s.copier};
  s.chosen.reserve(count);
  s.parts.reserve(count);
  const std::shared_ptr<unsigned char> memory = s.results->take(count * sizeof(OutsidePart)).memory;
  const std::span<OutsidePart> parts{reinterpret_cast<OutsidePart*>(memory.get()), count};
  s.stream.send(s.chosen, tetrahedra.data(), count);
  constexpr unsigned kThreads = 128;
  if (count > 0) {
    launch(measure_outside,
           {static_cast<unsigned>((count + kThreads - 1) / kThreads), kThreads, s.stream},
           s.last_at, s.chosen.get(), static_cast<std::uint32_t>(count), solvent, s.parts.get());
    check(cudaGetLastError(), "starting a kernel");
  }
  s.stream.fetch(parts.data(), s.parts.get(), count);
  s.stream.wait("measuring cavities");
  cancel.throw_if_cancelled();
  return in_place(memory, parts);
}

}  // namespace alphascope::gpu
