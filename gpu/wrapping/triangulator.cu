// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a regular triangulation on the device: the tetrahedra of a small alpha by the dual-edge
// kernels, all others by wrapping, a certificate, and the order of a Triangulation.
#include "gpu/wrapping/triangulator.hpp"

#include <cub/device/device_radix_sort.cuh>

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <utility>

#include "core/geometry/alpha.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/insertion/order_tetrahedra.hpp"
#include "core/run/stage_timer.hpp"
#include "core/wrapping/hull_proof.hpp"
#include "gpu/dual_edge/dual_edge_pipeline.hpp"
#include "gpu/gpu_engine.hpp"
#include "gpu/memory/device_allocation.hpp"
#include "gpu/memory/prefix_sum.cuh"
#include "gpu/memory/result_memory.cuh"
#include "gpu/whole/faces_maker.hpp"
#include "gpu/wrapping/arrange.cuh"
#include "gpu/wrapping/certificate.cuh"
#include "gpu/wrapping/wrapped.cuh"
#include "gpu/wrapping/wrapping.hpp"

namespace alphascope {
namespace gpu {
namespace {

// The radius of balls in the first step, in small gaps. Larger ones take the kernels of the first
// step longer than wrapping takes. Where the largest ball is some times as large, or where more
// runs than these are needed, balls are too unlike for that step.
constexpr double kMostReach = 3;
constexpr int kMostAttempts = 4;
constexpr double kRadiusPerGap = 2.5;
constexpr double kTetrahedraPerBall = 6.9;
// A face has a 32-bit reference.
constexpr std::size_t kMostQuads = std::size_t{1} << 30;

// Times of named stages by the device's clock. A stage may have several parts.
class StageClock {
 public:
  explicit StageClock(cudaStream_t stream) : stream_(stream) {}
  void begin(std::string_view label) {
    end();
    timers_.emplace_back(label, std::make_unique<DeviceTimer>(stream_));
    stopped_ = false;
  }
  void end() {
    if (!timers_.empty() && !stopped_) timers_.back().second->stop();
    stopped_ = true;
  }
  // Waits for the end of all work.
  double milliseconds(std::string_view of) {
    end();
    double sum = 0;
    for (auto& [label, timer] : timers_) sum += label == of ? timer->milliseconds() : 0;
    return sum;
  }

 private:
  cudaStream_t stream_;
  bool stopped_ = false;
  std::vector<std::pair<std::string_view, std::unique_ptr<DeviceTimer>>> timers_;
};

// Numbers that the device counts in the last steps.
struct LastCounts {
  CertificateCounts certificate;
  std::uint32_t hull;  // faces that are listed
  std::uint32_t vertices;
};

// Arrays that are copied to the host. The first `kept` bytes are the result's, and stay there. The
// others come first.
struct TriangulationLayout {
  std::size_t neighbours, kept, hull, listed, bytes;
  TriangulationLayout(std::size_t quads, std::size_t balls, std::size_t hull_room)
      : neighbours(quads * sizeof(uint4)),
        kept(2 * neighbours),
        hull(kept + (hull_room + 1) * sizeof(uint4)),
        listed(hull + hull_room * sizeof(std::uint32_t)),
        bytes(listed + balls * sizeof(std::uint32_t)) {}
  std::size_t hull_balls() const { return kept; }
  std::size_t first_bytes() const { return bytes - kept; }
};

// The median weight of evenly spread samples, square lattice units.
double typical_weight(const BallSet& balls) {
  constexpr std::size_t kSamples = 1024;
  const std::size_t samples = std::min(kSamples, balls.size());
  std::vector<std::int64_t> weights(samples);
  for (std::size_t n = 0; n < samples; ++n)
    weights[n] = balls.weight(static_cast<BallIndex>(n * balls.size() / samples));
  const auto middle = weights.begin() + static_cast<std::ptrdiff_t>(samples / 2);
  std::nth_element(weights.begin(), middle, weights.end());
  return static_cast<double>(*middle);
}

class GpuTriangulator : public DeviceTriangulator {
 public:
  GpuTriangulator(FindSeed find_seed, std::function<void(Uncertified&)> spoil)
      : find_seed_(std::move(find_seed)), spoil_(std::move(spoil)) {}
  ~GpuTriangulator() override { results_->close(); }

  DeviceTriangulation make(const BallSet& balls, const RunContext& context) override {
    DeviceTriangulation made;
    made.report.maker = gpu_device().name;
    StageTimes whole;
    StageTimer wall(whole);
    try {
      triangulate(balls, context, made);
    } catch (const std::bad_alloc&) {
      made.report.why_not = made.report.maker + " has too little memory for this triangulation";
    } catch (const ExecutorFailed& failed) {
      made.report.why_not = failed.what();
    }
    if (!made.triangulation) forget_memory();
    wall.finish();
    made.report.timings.wall_milliseconds = whole.wall_milliseconds;
    return made;
  }

  std::optional<FiltrationParts> filtration_parts(const BallSet& balls,
                                                  const Triangulation& triangulation,
                                                  const RunContext& context,
                                                  std::string& why_not) override {
    expect(triangulation);
    std::optional<FiltrationParts> made = made_of<FiltrationParts>(why_not, [&](FacesMaker& faces) {
      return faces.filtration_parts(balls, triangulation, on_device(triangulation), context,
                                    why_not);
    });
    if (made) made->device = gpu_device().name;
    return made;
  }
  std::optional<TriangulationGround> ground(const BallSet& balls,
                                            const Triangulation& triangulation, FlowTies ties,
                                            const RunContext& context,
                                            std::string& why_not) override {
    expect(triangulation);
    return made_of<TriangulationGround>(why_not, [&](FacesMaker& faces) {
      return faces.ground(balls, triangulation, on_device(triangulation), ties, context, why_not);
    });
  }

  std::optional<Membership> membership(const Incidence& incidence, const LatticeAlpha& alpha,
                                       const CancelToken& cancel) override {
    std::string why_not;
    if (!faces_) return std::nullopt;
    return made_of<Membership>(
        why_not, [&](FacesMaker& faces) { return faces.membership(incidence, alpha, cancel); });
  }

  std::optional<ResultArray<OutsidePart>> outside_parts(const Membership& in,
                                                        std::span<const std::uint32_t> tetrahedra,
                                                        double solvent,
                                                        const CancelToken& cancel) override {
    std::string why_not;
    if (!faces_) return std::nullopt;
    return made_of<ResultArray<OutsidePart>>(why_not, [&](FacesMaker& faces) {
      return faces.outside_parts(in, tetrahedra, solvent, cancel);
    });
  }

  bool takes_much_room() override {
    std::size_t free = 0, all = 0;
    if (!std::exchange(grown_, false)) return false;
    return device_memory_room(&free, &all) != cudaSuccess || free < all / 2;
  }

  void release_memory() override {
    forget_memory();
    results_->release_memory();
    ResultMemory::free_unused();
  }

 private:
  void forget_memory() {
    last_ = {};
    memory_ = {};
    faces_ = {};
    most_balls_ = most_followed_ = 0;
  }

  // Notes whether more memory will be kept than before.
  void expect(const Triangulation& triangulation) {
    const std::size_t count = triangulation.tetrahedra.size();
    grown_ = grown_ || count > most_followed_;
    most_followed_ = std::max(most_followed_, count);
  }
  // Calls make(faces). An error is told in `why_not`.
  template <class Made, class Make>
  std::optional<Made> made_of(std::string& why_not, const Make& make) {
    try {
      if (!faces_) faces_ = std::make_unique<FacesMaker>();
      return make(*faces_);
    } catch (const std::bad_alloc&) {
      why_not = gpu_device().name + " has too little memory for this";
    } catch (const ExecutorFailed& failed) {
      why_not = failed.what();
    }
    forget_memory();
    return std::nullopt;
  }
  // The last result in device memory, if it is this triangulation.
  TriangulationOnDevice on_device(const Triangulation& triangulation) const {
    const std::shared_ptr<unsigned char> last = last_.lock();
    const void* const tetrahedra = triangulation.tetrahedra.data();
    if (!last || !memory_ || tetrahedra != last.get()) return {};
    return {memory_->result.get(),
            memory_->result.get() + triangulation.tetrahedra.size() * sizeof(uint4)};
  }

  void triangulate(const BallSet& balls, const RunContext& context, DeviceTriangulation& made) {
    if (balls.size() > Wrapping::kMost) {
      made.report.why_not = "more balls than the device's triangulation can have";
      return;
    }
    if (balls.size() < 4) {
      made.report.why_not = kFlat;
      return;
    }
    if (!memory_) memory_ = std::make_unique<Memory>();
    Memory& m = *memory_;
    grown_ = grown_ || balls.size() > most_balls_;
    most_balls_ = std::max(most_balls_, balls.size());
    context.report(stage::kTriangulation, 0);
    StageTimer host(made.report.timings);
    m.wrapping.load(balls);
    host.lap(stage::kHostToDevice, false);
    context.cancel.throw_if_cancelled();
    const double radius = kRadiusPerGap * m.wrapping.small_gap();
    const std::optional<DeviceSimplices> known = find_known(balls, radius, context.cancel);
    if (!known) {
      made.report.why_not = kFlat;
      return;
    }
    host.lap(stage::kBulk, false);
    context.report(stage::kTriangulation, 0.3);
    if (!wrap(balls, *known, radius, context.cancel, made)) {
      made.report.why_not = "more tetrahedra than the device can number";
      return;
    }
    context.report(stage::kTriangulation, 0.7);
    Wrapped all = m.wrapping.on_device();
    spoil(all);
    finish(balls, all, context.cancel, made);
  }

  // Tetrahedra with which wrapping begins: those of a K_alpha, or any one. Empty if the centres lie
  // in a plane.
  std::optional<DeviceSimplices> find_known(const BallSet& balls, double radius,
                                            const CancelToken& cancel) {
    Memory& m = *memory_;
    const double weight = typical_weight(balls), units = balls.lattice.units_per_angstrom();
    const std::optional<DeviceBalls> shown = m.wrapping.shown_balls();
    const double reach = kMostReach * radius,
                 most = static_cast<double>(shown ? shown->max_radius : 0);
    const bool alike = shown && most * most - weight + radius * radius < reach * reach;
    if (alike) m.pipeline.load(*shown);
    m.pipeline.set_most_attempts(kMostAttempts);
    // Where balls are clustered, fewer of them fit.
    for (const double share : {1.0, 0.6, 0.36}) {
      if (!alike) break;
      const double alpha = (share * share * radius * radius - weight) / (units * units);
      cancel.throw_if_cancelled();
      const PipelineResult within =
          m.pipeline.run(balls.lattice.alpha_on_lattice(Alpha{alpha}), true, cancel, nullptr);
      const DeviceSimplices found = m.pipeline.tetrahedra_on_device();
      if (within.fits && found.count > 0) return found;
      if (within.fits) break;
    }
    const std::optional<std::array<BallIndex, 4>> seed = find_seed_(balls, cancel);
    if (!seed) return std::nullopt;
    m.seed.reserve(4);
    check(cudaMemcpy(m.seed.get(), seed->data(), sizeof *seed, cudaMemcpyHostToDevice),
          "sending a tetrahedron");
    return DeviceSimplices{m.seed.get(), nullptr, 1};
  }

  bool wrap(const BallSet& balls, const DeviceSimplices& known, double radius,
            const CancelToken& cancel, DeviceTriangulation& made) {
    const double likely =
        kTetrahedraPerBall * static_cast<double>(balls.size()) - static_cast<double>(known.count);
    for (auto room = static_cast<std::size_t>(std::max(likely, 0.0)) + 4096;
         known.count + room < kMostQuads; room *= 2) {
      const WrappingResult result = memory_->wrapping.run(known, radius, room, false, cancel);
      if (!result.fits) continue;
      made.report.known = result.known;
      made.report.open_faces = result.open;
      made.report.needed = result.needed;
      made.report.waves = result.rounds;
      made.report.timings.stages.push_back(
          {std::string(stage::kOpenFaces), result.open_ms + result.tree_ms, false});
      made.report.timings.stages.push_back({std::string(stage::kWrapping), result.front_ms, false});
      return true;
    }
    return false;
  }

  // The order, the certificate and the copy to the host. While the result is on its way, the device
  // checks the tetrahedra, and the host the hull.
  void finish(const BallSet& balls, const Wrapped& all, const CancelToken& cancel,
              DeviceTriangulation& made) {
    Memory& m = *memory_;
    const WorkStream& stream = *all.stream;
    const std::size_t count = all.count, n = all.slots;
    // A wrong result may have more faces there, and is refused then.
    const std::size_t hull_room = std::size_t{2} * all.hull + 64;
    const TriangulationLayout layout(count, n, hull_room);
    last_ = {};
    if (faces_) faces_->forget_ground();
    m.prepare(layout);
    const std::shared_ptr<unsigned char> memory = results_->take(layout.kept).memory;
    const WaitAtEnd waits{stream, m.copier};
    const auto array = [&](std::size_t at) { return m.result.get() + at; };
    stream.fill(m.counts, 0, 1);
    StageClock clock(stream);
    clock.begin(stage::kCertificate);
    m.wrapping.mark_balls(all.count);
    clock.begin(stage::kOrder);
    const Arranged arranged{reinterpret_cast<uint4*>(array(0)),
                            reinterpret_cast<uint4*>(array(layout.neighbours)),
                            reinterpret_cast<std::uint32_t*>(array(layout.hull)),
                            static_cast<std::uint32_t>(hull_room),
                            &m.counts.get()->hull,
                            reinterpret_cast<uint4*>(array(layout.hull_balls()))};
    arrange(all, arranged, reinterpret_cast<std::uint32_t*>(array(layout.listed)));
    m.arranged.record(stream);
    clock.begin(stage::kCertificate);
    certify(all);
    clock.end();
    m.certified.record(stream);

    const WorkStream& copier = m.copier;
    m.arranged.make_wait(copier);
    copier.fetch(m.first.get(), array(layout.kept), layout.first_bytes());
    copier.fetch(&m.host_counts.get()->hull, &m.counts.get()->hull, 1);
    copier.fetch(&m.host_counts.get()->vertices, m.place.get() + n, 1);
    m.first_here.record(copier);
    copier.fetch(memory.get(), m.result.get(), layout.kept);
    m.certified.make_wait(copier);
    copier.fetch(&m.host_counts.get()->certificate, &m.counts.get()->certificate, 1);

    check(cudaEventSynchronize(m.first_here), "putting a triangulation in order");
    StageTimes last;
    StageTimer host(last);
    Triangulation result = in_result_memory(memory, layout, count);
    const LastCounts& counts = *m.host_counts.get();
    const auto* const listed =
        reinterpret_cast<const BallIndex*>(m.first_bytes(layout.listed, layout));
    result.vertices.assign(listed, listed + counts.vertices);
    result.hidden.assign(listed + counts.vertices, listed + n);
    const auto* const hull_balls = reinterpret_cast<const std::array<BallIndex, 4>*>(
        m.first_bytes(layout.hull_balls(), layout));
    std::vector<OutsideFace> outside =
        outside_faces(layout, std::min<std::size_t>(counts.hull, hull_room), n);
    std::vector<HullFacet> facets = hull_facets(balls, outside);
    const auto& inside = hull_balls[hull_room];
    const bool encloses = are_balls(inside, n) && encloses_once(balls, facets, inside);
    host.lap(stage::kHull);
    copier.wait("copying a triangulation");
    cancel.throw_if_cancelled();
    const CertificateCounts& checked = counts.certificate;
    if (checked.cells + checked.pairs + checked.irregular + checked.unproven > 0)
      throw ExecutorFailed(failure(checked));
    if (!encloses || checked.hull != facets.size())
      throw ExecutorFailed("the certificate of the triangulation failed: its hull is not convex");
    set_hull(std::move(facets), outside, result);
    made.triangulation = std::move(result);
    last_ = memory;

    host.lap(stage::kDeviceToHost);
    const double certificate = clock.milliseconds(stage::kCertificate);
    // Of the copy counts what took longer than the checks beside it.
    StageTime& copy = last.stages.back();
    copy.milliseconds = std::max(0.0, copy.milliseconds - certificate);
    std::vector<StageTime>& stages = made.report.timings.stages;
    stages.push_back({std::string(stage::kOrder), clock.milliseconds(stage::kOrder), false});
    stages.push_back({std::string(stage::kCertificate), certificate, false});
    stages.insert(stages.end(), last.stages.begin(), last.stages.end());
  }

  // Queues all checks of the device, after those of hidden balls.
  void certify(const Wrapped& all) {
    const WorkStream& stream = *all.stream;
    const Certificate certificate{all.faces,
                                  all.count,
                                  all.balls,
                                  all.slots,
                                  all.scale,
                                  all.spare,
                                  &memory_->counts.get()->certificate};
    const std::size_t count = all.count;
    stream.each(check_cells, count, certificate);
    stream.each(check_faces, 4 * count, certificate);
    stream.each(check_doubtful_faces, std::min<std::size_t>(2 * count, 1u << 18), certificate);
    stream.each(count_unproven, all.slots, all.found, all.slots, certificate.counts);
  }

  void arrange(const Wrapped& all, const Arranged& out, std::uint32_t* listed) {
    Memory& m = *memory_;
    const WorkStream& stream = *all.stream;
    const std::size_t count = all.count, n = all.slots;
    m.lower.reserve(count);
    m.higher.reserve(count);
    m.gathered.reserve(count);
    m.sorted_keys.reserve(count);
    m.index.reserve(count);
    m.order.reserve(count);
    const int bits = std::bit_width(n - 1);
    stream.each(find_keys, count, all.faces.quads, all.count, all.ball_of_slot, bits, m.lower.get(),
                m.higher.get(), m.index.get());
    sort(m.higher.get(), m.index.get(), m.order.get(), count, 2 * bits, stream);
    stream.each(gather_keys, count, m.lower.get(), m.order.get(), all.count, m.gathered.get());
    sort(m.gathered.get(), m.order.get(), m.index.get(), count, 2 * bits, stream);
    // `index` is the order now, and `order` becomes its inverse.
    stream.each(invert_order, count, m.index.get(), all.count, m.order.get());
    stream.each(arrange_quads, count, all.faces, all.count, all.ball_of_slot, m.index.get(),
                m.order.get(), out);
    stream.each(gather_hull, out.hull_room + 1, out);
    m.is_vertex.reserve(n + 1);
    m.place.reserve(n + 1);
    stream.fill(m.is_vertex, 0, n + 1);
    stream.each(mark_vertices, n, all.found, all.ball_of_slot, all.slots, m.is_vertex.get());
    prefix_sum(m.is_vertex.get(), m.place.get(), n + 1, m.scratch, stream);
    stream.each(list_balls, n, m.is_vertex.get(), m.place.get(), all.slots, listed);
  }
  void sort(const std::uint64_t* keys, const std::uint32_t* from, std::uint32_t* to,
            std::size_t count, int bits, const WorkStream& stream) {
    Memory& m = *memory_;
    std::size_t bytes = 0;
    const auto run = [&](void* scratch) {
      check(cub::DeviceRadixSort::SortPairs(scratch, bytes, keys, m.sorted_keys.get(), from, to,
                                            static_cast<int>(count), 0, bits, stream),
            "sorting tetrahedra");
    };
    run(nullptr);
    m.scratch.reserve(bytes);
    run(m.scratch.get());
  }

  // The tetrahedra and neighbours, which are still on their way.
  static Triangulation in_result_memory(const std::shared_ptr<unsigned char>& memory,
                                        const TriangulationLayout& layout, std::size_t count) {
    static_assert(sizeof(Neighbour) == 4 &&
                  std::bit_cast<std::uint32_t>(Neighbour::tetrahedron(7)) == 7);
    Triangulation result;
    result.dimension = 3;
    using Balls = std::array<BallIndex, 4>;
    using Neighbours = std::array<Neighbour, 4>;
    unsigned char* const at = memory.get();
    result.tetrahedra = in_place(memory, std::span<Balls>{reinterpret_cast<Balls*>(at), count});
    result.neighbours = in_place(
        memory,
        std::span<Neighbours>{reinterpret_cast<Neighbours*>(at + layout.neighbours), count});
    return result;
  }
  // The result is not certified yet.
  static bool are_balls(const std::array<BallIndex, 4>& indices, std::size_t balls) {
    return std::all_of(indices.begin(), indices.end(), [&](BallIndex i) { return i < balls; });
  }
  // Leaves out faces of what are no balls. Their number is then wrong, and the result refused.
  std::vector<OutsideFace> outside_faces(const TriangulationLayout& layout, std::size_t count,
                                         std::size_t all_balls) const {
    const Memory& m = *memory_;
    const auto* const hull =
        reinterpret_cast<const std::uint32_t*>(m.first_bytes(layout.hull, layout));
    const auto* const balls = reinterpret_cast<const std::array<BallIndex, 4>*>(
        m.first_bytes(layout.hull_balls(), layout));
    std::vector<OutsideFace> outside;
    outside.reserve(count);
    for (std::size_t h = 0; h < count; ++h) {
      if (are_balls(balls[h], all_balls))
        outside.push_back({hull[h] / 4, static_cast<int>(hull[h] % 4), balls[h]});
    }
    return outside;
  }

  static std::string failure(const CertificateCounts& counts) {
    std::string text = "the certificate of the triangulation failed;";
    const char* separator = " ";
    const auto add = [&](const char* what, std::uint32_t count) {
      if (count == 0) return;
      text += separator + std::string(what) + ": " + std::to_string(count);
      separator = ", ";
    };
    add("tetrahedra that are flat or turned", counts.cells);
    add("wrong neighbours", counts.pairs);
    add("faces that are not regular", counts.irregular);
    add("balls neither in a tetrahedron nor hidden", counts.unproven);
    return text;
  }

  void spoil(Wrapped& all) const;

  static constexpr const char* kFlat = "the centres of all balls lie in a plane";

  // All that is kept for the next call.
  struct Memory {
    Wrapping wrapping;
    DualEdgePipeline pipeline;
    DeviceBuffer<BallIndex> seed;
    DeviceBuffer<LastCounts> counts;
    PinnedBuffer<LastCounts> host_counts;
    DeviceBuffer<std::uint64_t> lower, higher, gathered, sorted_keys;
    DeviceBuffer<std::uint32_t> index, order, is_vertex, place;
    DeviceBuffer<unsigned char> scratch, result;
    PinnedBuffer<unsigned char> first;  // what the host needs before the result
    WorkStream copier;
    Event arranged, first_here, certified;

    Memory() {
      copier.create();
      for (Event* const event : {&arranged, &first_here, &certified})
        event->create(cudaEventDisableTiming);
    }
    void prepare(const TriangulationLayout& layout) {
      counts.reserve(1);
      host_counts.reserve(1);
      result.reserve(layout.bytes);
      first.reserve(layout.first_bytes());
    }
    const unsigned char* first_bytes(std::size_t at, const TriangulationLayout& layout) const {
      return first.get() + (at - layout.kept);
    }
  };
  std::unique_ptr<Memory> memory_;
  std::unique_ptr<FacesMaker> faces_;
  std::weak_ptr<unsigned char> last_;  // the last result on the host, which is also in `memory_`
  std::size_t most_balls_ = 0;         // for which it is kept
  std::size_t most_followed_ = 0;      // tetrahedra of which faces were made
  bool grown_ = false;                 // since takes_much_room() was called
  std::shared_ptr<ResultMemory> results_ = std::make_shared<ResultMemory>();
  FindSeed find_seed_;
  std::function<void(Uncertified&)> spoil_;  // of tests; else empty
};

// Lets a test spoil the triangulation.
void GpuTriangulator::spoil(Wrapped& all) const {
  if (!spoil_) return;
  Uncertified host{std::vector<std::array<std::uint32_t, 4>>(all.count),
                   std::vector<std::array<std::uint32_t, 4>>(all.count)};
  const std::size_t bytes = all.count * sizeof(Quad);
  const auto copy = [&](void* to, const void* from, std::size_t size, cudaMemcpyKind kind) {
    check(cudaMemcpyAsync(to, from, size, kind, *all.stream), "copying tetrahedra");
    all.stream->wait("copying tetrahedra");
  };
  copy(host.quads.data(), all.faces.quads, bytes, cudaMemcpyDeviceToHost);
  copy(host.neighbours.data(), all.faces.neighbours, bytes, cudaMemcpyDeviceToHost);
  spoil_(host);
  all.count = static_cast<std::uint32_t>(host.quads.size());
  copy(all.faces.quads, host.quads.data(), all.count * sizeof(Quad), cudaMemcpyHostToDevice);
  copy(all.faces.neighbours, host.neighbours.data(), all.count * sizeof(Quad),
       cudaMemcpyHostToDevice);
}

}  // namespace

std::unique_ptr<DeviceTriangulator> make_spoilt_triangulator(
    FindSeed find_seed, std::function<void(Uncertified&)> spoil) {
  return std::make_unique<GpuTriangulator>(std::move(find_seed), std::move(spoil));
}

}  // namespace gpu

std::unique_ptr<DeviceTriangulator> make_gpu_triangulator(FindSeed find_seed) {
  return gpu::make_spoilt_triangulator(std::move(find_seed), {});
}

}  // namespace alphascope
