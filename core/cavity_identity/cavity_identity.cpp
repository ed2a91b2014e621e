// SPDX-License-Identifier: GPL-3.0-or-later
// Matches the cavities of two tables: by deepest sinks in one triangulation, else by shared volume
// in exact integers.
#include "core/cavity_identity/cavity_identity.hpp"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <utility>

#include "core/cavity/cavities.hpp"
#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/cavity/tetrahedron_order.hpp"
#include "core/cavity_identity/point_location.hpp"
#include "core/complex/face_class.hpp"
#include "core/predicates/perturbation.hpp"
#include "core/run/parallel.hpp"
#include "core/run/stage_timer.hpp"

namespace alphascope {
namespace {

constexpr std::uint32_t kNone = CavityMatch::kNone;
using Sink = std::array<BallIndex, 4>;

// Six times the volume of a tetrahedron in cubic lattice units, below 2^95. A cavity has fewer than
// 2^31 tetrahedra, so sums stay below 2^126.
Int128 six_volumes(const BallSet& balls, const std::array<BallIndex, 4>& corners) {
  const auto from_first = [&](std::size_t k) {
    return lifted_vector(balls.centres[corners[0]], 0, balls.centres[corners[k]], 0);
  };
  const Int128 signed_volume = determinant(from_first(1), from_first(2), from_first(3));
  return signed_volume < 0 ? -signed_volume : signed_volume;
}

struct Share {
  std::uint32_t earlier, later;
  Int128 volume;
};

// Keeps for each cavity the candidate of the largest share. Among equal shares it keeps the
// candidate whose sink comes first by the positions of its centres.
class Largest {
 public:
  Largest(std::size_t cavities, std::span<const Sink> sinks, const BallSet& balls)
      : best_(cavities, kNone), volume_(cavities, 0), sinks_(sinks), balls_(balls) {}
  void offer(std::uint32_t of, std::uint32_t candidate, Int128 volume) {
    std::uint32_t& best = best_[of];
    if (best != kNone &&
        (volume < volume_[of] ||
         (volume == volume_[of] && !comes_first(balls_, sinks_[candidate], sinks_[best])))) {
      return;
    }
    best = candidate;
    volume_[of] = volume;
  }
  std::vector<std::uint32_t> take() { return std::move(best_); }

 private:
  std::vector<std::uint32_t> best_;
  std::vector<Int128> volume_;
  std::span<const Sink> sinks_;
  const BallSet& balls_;
};

// Adds up the shares of single tetrahedra, one later cavity after the other.
class ShareSums {
 public:
  explicit ShareSums(std::size_t earlier) : sum_(earlier, 0), last_(earlier, kNone) {}
  void add(std::uint32_t earlier, std::uint32_t later, Int128 volume) {
    if (std::exchange(last_[earlier], later) != later) {
      touched_.push_back(earlier);
      sum_[earlier] = 0;
    }
    sum_[earlier] += volume;
  }
  // Appends the sums of the later cavity that was added to.
  void finish(std::uint32_t later, std::vector<Share>& shares) {
    for (const std::uint32_t earlier : touched_) shares.push_back({earlier, later, sum_[earlier]});
    touched_.clear();
  }

 private:
  std::vector<Int128> sum_;
  std::vector<std::uint32_t> last_, touched_;
};

CavityMatch match_of(const std::vector<Share>& shares, std::span<const Sink> earlier,
                     std::span<const Sink> later, const BallSet& balls) {
  Largest came_from(later.size(), earlier, balls), goes_to(earlier.size(), later, balls);
  for (const Share& share : shares) {
    came_from.offer(share.later, share.earlier, share.volume);
    goes_to.offer(share.earlier, share.later, share.volume);
  }
  return {came_from.take(), goes_to.take()};
}

std::vector<Sink> sinks_of(const CavityTable& table) {
  std::vector<Sink> sinks;
  for (const Cavity& cavity : table.found.cavities) {
    sinks.push_back(table.ground->triangulation->tetrahedra[cavity.deepest_sink]);
  }
  return sinks;
}

// Finds the first of sorted tetrahedra that is not less than a given one. Each call of place_of()
// must be for a tetrahedron that is no less than that of the call before.
class SortedPlaces {
 public:
  // `from` is no more than the tetrahedron of the first call.
  SortedPlaces(const Simplices<4>& sorted, const std::array<BallIndex, 4>& from)
      : sorted_(sorted),
        at_(static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), from) -
                                     sorted.begin())) {}

  std::uint32_t place_of(const std::array<BallIndex, 4>& corners) {
    while (at_ < sorted_.size() && sorted_[at_] < corners) ++at_;
    return static_cast<std::uint32_t>(at_);
  }

 private:
  const Simplices<4>& sorted_;
  std::size_t at_;
};

LatticePlace centroid(const BallSet& balls, const std::array<BallIndex, 4>& corners) {
  LatticePlace place{0, 0, 0, 4};
  for (const BallIndex v : corners) {
    place.x += balls.centres[v].x;
    place.y += balls.centres[v].y;
    place.z += balls.centres[v].z;
  }
  return place;
}

// The earlier cavity that contains the centroid of a tetrahedron of a later cavity. `next` is its
// place among the earlier tetrahedra: the tetrahedron there has the most balls in common with it,
// so the search begins there.
std::uint32_t cavity_at_centroid(const CavityTable& earlier,
                                 const std::array<BallIndex, 4>& corners, std::uint32_t next) {
  const CavityGround& ground = *earlier.ground;
  const Simplices<4>& tetrahedra = ground.triangulation->tetrahedra;
  std::uint32_t at = std::min(next, static_cast<std::uint32_t>(tetrahedra.size() - 1));
  if (tetrahedra[at] != corners) {
    // Uses the earlier balls' lattice. It may be finer or coarser than the later one, but both
    // contain all centres.
    at = walk_to(centroid(*ground.balls, corners), *ground.balls, *ground.triangulation, at);
  }
  return at == kOutsideHull ? kNone : earlier.found.cavity_of_tetrahedron[at];
}

// What each tetrahedron of a later cavity shares with the earlier ones.
struct SharedVolumes {
  ResultArray<std::uint32_t> with;  // the earlier cavity that contains its centroid, or kNone
  ResultArray<Int128> six_volumes;  // written where there is one
};

SharedVolumes shared_volumes(const CavityTable& earlier, const CavityTable& later,
                             const CancelToken& cancel) {
  constexpr std::size_t kGrain = 1024;
  const ResultArray<std::uint32_t>& labels = later.found.cavity_of_tetrahedron;
  const Simplices<4>& tetrahedra = later.ground->triangulation->tetrahedra;
  SharedVolumes shared;
  shared.with.resize(labels.size());
  shared.six_volumes.resize(labels.size());
  parallel_ranges(0, labels.size(), kGrain, [&](std::size_t first, std::size_t end) {
    if (cancel.cancelled()) return;
    SortedPlaces places(earlier.ground->triangulation->tetrahedra, tetrahedra[first]);
    for (std::size_t t = first; t != end; ++t) {
      shared.with[t] = kNone;
      if (labels[t] == Cavities::kNone) continue;
      shared.with[t] = cavity_at_centroid(earlier, tetrahedra[t], places.place_of(tetrahedra[t]));
      if (shared.with[t] == kNone) continue;
      shared.six_volumes[t] = six_volumes(*later.ground->balls, tetrahedra[t]);
    }
  });
  cancel.throw_if_cancelled();
  return shared;
}

// In one triangulation cavities only split as alpha grows. So deepest sinks identify them.
CavityMatch match_by_sinks(const CavityTable& earlier, const CavityTable& later) {
  const auto at_sinks = [](const CavityTable& of, const CavityTable& in) {
    std::vector<std::uint32_t> cavities;
    for (const Cavity& cavity : of.found.cavities) {
      cavities.push_back(in.found.cavity_of_tetrahedron[cavity.deepest_sink]);
    }
    return cavities;
  };
  return {at_sinks(later, earlier), at_sinks(earlier, later)};
}

}  // namespace

std::vector<std::uint32_t> CavityMatch::parts(std::uint32_t earlier) const {
  std::vector<std::uint32_t> list;
  for (std::uint32_t n = 0; n < came_from.size(); ++n) {
    if (came_from[n] == earlier) list.push_back(n);
  }
  return list;
}

std::vector<std::uint32_t> CavityMatch::sources(std::uint32_t later) const {
  std::vector<std::uint32_t> list;
  for (std::uint32_t n = 0; n < goes_to.size(); ++n) {
    if (goes_to[n] == later) list.push_back(n);
  }
  return list;
}

CavityMatch match_cavities(const CavityTable& earlier, const CavityTable& later,
                           const CancelToken& cancel) {
  if (earlier.ground->balls->size() != later.ground->balls->size()) {
    throw std::invalid_argument("cavities of other atoms cannot be compared");
  }
  if (earlier.ground == later.ground) return match_by_sinks(earlier, later);
  const std::vector<Sink> sinks_before = sinks_of(earlier), sinks_now = sinks_of(later);
  const BallSet& balls = *later.ground->balls;
  if (sinks_before.empty() || sinks_now.empty()) {
    return match_of({}, sinks_before, sinks_now, balls);
  }
  const SharedVolumes shared = shared_volumes(earlier, later, cancel);
  ShareSums sums(sinks_before.size());
  std::vector<Share> shares;
  for (std::uint32_t c = 0; c < sinks_now.size(); ++c) {
    for (const std::uint32_t t : later.found.cavities[c].tetrahedra) {
      if (shared.with[t] != kNone) sums.add(shared.with[t], c, shared.six_volumes[t]);
    }
    sums.finish(c, shares);
  }
  return match_of(shares, sinks_before, sinks_now, balls);
}

CavityRegions regions_of(const CavityTable& table) {
  CavityRegions regions;
  const auto& labels = table.found.cavity_of_tetrahedron;
  for (std::size_t t = 0; t < labels.size(); ++t) {
    if (labels[t] == Cavities::kNone) continue;
    regions.tetrahedra.push_back(table.ground->triangulation->tetrahedra[t]);
    regions.cavity.push_back(labels[t]);
  }
  regions.sinks = sinks_of(table);
  return regions;
}

CavityMatch match_regions(const CavityRegions& earlier, const CavityRegions& later,
                          const BallSet& balls) {
  std::vector<Share> single;
  SortedPlaces places(earlier.tetrahedra, {});
  for (std::size_t t = 0; t < later.tetrahedra.size(); ++t) {
    const std::uint32_t at = places.place_of(later.tetrahedra[t]);
    if (at == earlier.tetrahedra.size() || earlier.tetrahedra[at] != later.tetrahedra[t]) continue;
    single.push_back(
        {earlier.cavity[at], later.cavity[t], six_volumes(balls, later.tetrahedra[t])});
  }
  std::sort(single.begin(), single.end(),
            [](const Share& a, const Share& b) { return a.later < b.later; });
  ShareSums sums(earlier.sinks.size());
  std::vector<Share> shares;
  for (std::size_t n = 0; n < single.size(); ++n) {
    sums.add(single[n].earlier, single[n].later, single[n].volume);
    if (n + 1 == single.size() || single[n + 1].later != single[n].later) {
      sums.finish(single[n].later, shares);
    }
  }
  return match_of(shares, earlier.sinks, later.sinks, balls);
}

}  // namespace alphascope
