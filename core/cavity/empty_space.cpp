#include "core/cavity/empty_space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "core/predicates/exact_alpha.hpp"
#include "core/predicates/perturbation.hpp"

namespace alphascope {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// ∫ dh / clearance² from `begin` to `end` >= begin >= 0, along a line on which power is
// `least` + h². Midpoints of steps that grow with the clearance: a few per cent.
double integrated_narrowness(double begin, double end, double least, double radius,
                             const WayCost& cost) {
  const auto clearance = [&](double h) {
    const double outside = std::sqrt(std::max(0.0, least + h * h) + radius * radius) - radius;
    return std::min(outside + cost.grown, cost.enough);
  };
  double sum = 0;
  while (begin < end) {
    const double step = std::min(end - begin, std::max(0.5 * clearance(begin), 0.02 * end));
    const double middle = clearance(begin + step / 2);
    sum += step / (middle * middle);
    begin += step;
  }
  return sum;
}

}  // namespace

std::array<BallIndex, 3> EmptySpace::face(std::uint32_t tetrahedron, std::size_t k) const {
  const auto& t = triangulation_.tetrahedra[tetrahedron];
  return {t[k == 0 ? 1 : 0], t[k <= 1 ? 2 : 1], t[k <= 2 ? 3 : 2]};
}

bool EmptySpace::is_empty(std::uint32_t tetrahedron) const {
  return compare_ortho_radius(balls_, triangulation_.tetrahedra[tetrahedron], 0) > 0;
}

// Between tetrahedra that are not in K, a face is in K iff its ortho-radius is at most 0 and no
// ball is in its smallest orthosphere; only neighbours can be.
bool EmptySpace::is_open(std::uint32_t tetrahedron, std::size_t k) const {
  const auto f = face(tetrahedron, k);
  if (compare_ortho_radius(balls_, f, 0) > 0) return true;
  bool on_face = false;
  least_power(tetrahedron, k, on_face);
  return !on_face;
}

bool EmptySpace::leads_out(std::uint32_t tetrahedron) const {
  for (std::size_t k = 0; k < 4; ++k) {
    if (triangulation_.neighbours[tetrahedron][k].is_hull() && is_open(tetrahedron, k)) return true;
  }
  return false;
}

double EmptySpace::power(std::uint32_t tetrahedron) const {
  return ortho_radius_rounded(balls_, triangulation_.tetrahedra[tetrahedron]);
}

double EmptySpace::least_power(std::uint32_t tetrahedron, std::size_t k, bool& on_face) const {
  const auto f = face(tetrahedron, k);
  const Neighbour across = triangulation_.neighbours[tetrahedron][k];
  on_face =
      conflict_with_smallest_orthosphere(balls_, f, triangulation_.tetrahedra[tetrahedron][k]) >= 0;
  if (across.is_hull()) {
    return on_face ? ortho_radius_rounded(balls_, f) : power(tetrahedron);
  }
  if (on_face) {
    const auto& other = triangulation_.tetrahedra[across.index()];
    std::size_t apex = 0;
    while (apex < 3 && other[apex] == f[apex]) ++apex;
    on_face = conflict_with_smallest_orthosphere(balls_, f, other[apex]) >= 0;
  }
  return on_face ? ortho_radius_rounded(balls_, f)
                 : std::min(power(tetrahedron), power(across.index()));
}

// Dijkstra's search by tetrahedra. relax(key, t, k) is the key of the neighbour across open face k
// when that of t is `key`: never less. Equal keys go by index, so the way is unique.
template <class Relax>
std::optional<EmptySpace::Way> EmptySpace::least_way(BallIndex from, BallIndex to,
                                                     const CancelToken& cancel,
                                                     const Relax& relax) const {
  constexpr std::uint32_t kNothing = ~std::uint32_t{0};
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const Simplices<4>& tetrahedra = triangulation_.tetrahedra;
  std::vector<double> key(tetrahedra.size(), kInfinity);
  std::vector<std::uint32_t> before(key.size(), kNothing);
  const auto is_around = [&](std::uint32_t t, BallIndex ball) {
    return std::find(tetrahedra[t].begin(), tetrahedra[t].end(), ball) != tetrahedra[t].end();
  };
  for (std::uint32_t t = 0; t < tetrahedra.size(); ++t) {
    if (!is_around(t, from)) continue;
    key[t] = -kInfinity;
    open.push({-kInfinity, t});
  }
  for (std::size_t steps = 0; !open.empty(); ++steps) {
    if (steps % 4096 == 0) cancel.throw_if_cancelled();
    const auto [own, t] = open.top();
    open.pop();
    if (own > key[t]) continue;
    if (to == kOutside ? leads_out(t) : is_around(t, to)) {
      Way way{t};
      while (before[way.back()] != kNothing) way.push_back(before[way.back()]);
      std::reverse(way.begin(), way.end());
      return way;
    }
    for (std::size_t k = 0; k < 4; ++k) {
      const Neighbour across = triangulation_.neighbours[t][k];
      if (across.is_hull() || key[across.index()] <= own) continue;
      if (!is_empty(across.index()) || !is_open(t, k)) continue;
      const double next = relax(own, t, k);
      if (next >= key[across.index()]) continue;
      key[across.index()] = next;
      before[across.index()] = t;
      open.push({next, across.index()});
    }
  }
  return std::nullopt;
}

std::optional<EmptySpace::Way> EmptySpace::widest_way(BallIndex from, BallIndex to,
                                                      const CancelToken& cancel) const {
  bool on_face = false;
  return least_way(from, to, cancel, [&](double key, std::uint32_t t, std::size_t k) {
    return std::max(key, -least_power(t, k, on_face));
  });
}

std::vector<std::array<BallIndex, 3>> EmptySpace::gaps(const Way& way) const {
  std::vector<std::array<BallIndex, 3>> result;
  for (std::size_t n = 0; n + 1 < way.size(); ++n) {
    std::size_t k = 0;
    while (triangulation_.neighbours[way[n]][k] != Neighbour::tetrahedron(way[n + 1])) ++k;
    bool on_face = false;
    least_power(way[n], k, on_face);
    if (on_face) result.push_back(face(way[n], k));
  }
  return result;
}

double EmptySpace::cost_across(std::uint32_t tetrahedron, std::size_t k,
                               const WayCost& cost) const {
  const auto f = face(tetrahedron, k);
  const Neighbour across = triangulation_.neighbours[tetrahedron][k];
  double radius = 0;
  for (const BallIndex i : f) {
    if (i < cost.ball_end) radius = std::max(radius, static_cast<double>(balls_.radii[i]));
  }
  bool on_face = false;
  least_power(tetrahedron, k, on_face);
  const double least = ortho_radius_rounded(balls_, f);
  const auto height = [&](std::uint32_t t) { return std::sqrt(std::max(0.0, power(t) - least)); };
  const double own = height(tetrahedron), other = height(across.index());
  const auto integral = [&](double begin, double end) {
    return integrated_narrowness(begin, end, least, radius, cost);
  };
  return on_face ? integral(0, own) + integral(0, other)
                 : integral(std::min(own, other), std::max(own, other));
}

std::optional<EmptySpace::Way> EmptySpace::cheapest_way(BallIndex from, BallIndex to,
                                                        const WayCost& cost,
                                                        const CancelToken& cancel) const {
  return least_way(from, to, cancel, [&](double key, std::uint32_t t, std::size_t k) {
    return std::max(key, 0.0) + cost_across(t, k, cost);
  });
}

// By Cramer's rule, with exact numerators: corners of flat tetrahedra are where they should be.
RealPoint EmptySpace::corner(std::uint32_t tetrahedron) const {
  const auto& t = triangulation_.tetrahedra[tetrahedron];
  const LiftedInt j = lifted_vector(balls_, t[0], t[1]), k = lifted_vector(balls_, t[0], t[2]),
                  l = lifted_vector(balls_, t[0], t[3]);
  const auto kl = cross(k, l), lj = cross(l, j), jk = cross(j, k);
  const double twice = 2 * static_cast<double>(determinant(j, k, l));
  const auto at = [&](std::int64_t a, std::int64_t b, std::int64_t c) {
    return static_cast<double>(Int128{j.c} * a + Int128{k.c} * b + Int128{l.c} * c) / twice;
  };
  return real_point(balls_.centres[t[0]]) +
         RealPoint{at(kl.x, lj.x, jk.x), at(kl.y, lj.y, jk.y), at(kl.z, lj.z, jk.z)};
}

}  // namespace alphascope
