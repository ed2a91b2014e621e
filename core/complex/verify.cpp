// The checks of verify.hpp, each in its own function. Conflicts use the exact predicates against
// every near ball; neighbourhood in the complex is never trusted for them.
#include "core/complex/verify.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>

#include "core/complex/face_groups.hpp"
#include "core/complex/filtration.hpp"
#include "core/geometry/coincident.hpp"
#include "core/geometry/exact_alpha.hpp"
#include "core/geometry/uniform_grid.hpp"

namespace alphascope {
namespace {

constexpr std::size_t kMaxMessages = 20;

class Findings {
 public:
  template <int N>
  void check(bool good, const std::array<BallIndex, N>& simplex, const char* what) {
    ++checks_;
    if (good) return;
    const std::lock_guard lock(mutex_);
    ++result_.failures;
    if (result_.messages.size() >= kMaxMessages) return;
    std::string name;
    for (const BallIndex v : simplex) name += (name.empty() ? "" : " ") + std::to_string(v);
    result_.messages.push_back("simplex {" + name + "}: " + what);
  }
  void fail(const std::string& what) {
    ++checks_;
    ++result_.failures;
    result_.messages.push_back(what);
  }
  Verification take() {
    result_.checks = checks_;
    return std::move(result_);
  }

 private:
  std::mutex mutex_;
  std::atomic<std::size_t> checks_ = 0;
  Verification result_;
};

// A ball in conflict with the orthosphere of a simplex of ortho-radius <= alpha reaches, grown by
// alpha, into each grown ball of it: so it is in the grid cells around the simplex's first ball.
class NearBalls {
 public:
  NearBalls(const BallSet& balls, double alpha)
      : balls_(balls), grid_(make_uniform_grid(balls, alpha, coincident_hidden(balls))) {}

  template <class Conflict>
  bool any(BallIndex i, const Conflict& conflict) const {
    const LatticePoint& p = balls_.centres[i];
    const int cx = grid_.cell_of(p.x, grid_.origin.x), cy = grid_.cell_of(p.y, grid_.origin.y),
              cz = grid_.cell_of(p.z, grid_.origin.z);
    const int z0 = std::max(cz - 1, 0), z1 = std::min(cz + 1, grid_.nz - 1);
    if (z1 < z0) return false;  // a hidden ball may lie outside the grid
    for (int x = std::max(cx - 1, 0); x <= std::min(cx + 1, grid_.nx - 1); ++x) {
      for (int y = std::max(cy - 1, 0); y <= std::min(cy + 1, grid_.ny - 1); ++y) {
        const std::size_t row = (static_cast<std::size_t>(x) * grid_.ny + y) * grid_.nz;
        for (auto s = grid_.cell_start[row + z0]; s < grid_.cell_start[row + z1 + 1]; ++s) {
          if (conflict(grid_.ball[s])) return true;
        }
      }
    }
    return false;
  }

 private:
  const BallSet& balls_;
  UniformGrid grid_;
};

template <int N>
bool contains(const std::array<BallIndex, N>& simplex, BallIndex m) {
  return std::find(simplex.begin(), simplex.end(), m) != simplex.end();
}

// Is pi_m < rho at the orthocentre x of a tetrahedron? With 2 x D = n as in orthosphere.hpp:
// (2 d_m·x - c_m) D² > 0, that is (d_m·n - c_m D) D > 0. Widths: 31 + 127 bits, and 63 + 94.
class TetrahedronConflict {
 public:
  using Wide = WideInt<4>;
  TetrahedronConflict(const BallSet& balls, const std::array<BallIndex, 4>& s)
      : balls_(balls), first_(s[0]) {
    const auto j = lifted_as<Wide>(lifted_vector(balls, s[0], s[1])),
               k = lifted_as<Wide>(lifted_vector(balls, s[0], s[2])),
               l = lifted_as<Wide>(lifted_vector(balls, s[0], s[3]));
    const auto kl = cross(k, l), lj = cross(l, j), jk = cross(j, k);
    determinant_ = dot(j, kl);
    n_ = {j.c * kl.x + k.c * lj.x + l.c * jk.x, j.c * kl.y + k.c * lj.y + l.c * jk.y,
          j.c * kl.z + k.c * lj.z + l.c * jk.z};
  }
  bool flat() const { return determinant_.sign() == 0; }
  bool operator()(BallIndex m) const {
    const auto v = lifted_as<Wide>(lifted_vector(balls_, first_, m));
    return (dot(v, n_) - v.c * determinant_).sign() * determinant_.sign() > 0;
  }

 private:
  const BallSet& balls_;
  BallIndex first_;
  Wide determinant_;
  Vector3<Wide> n_;
};

template <class Body>
void for_all(std::size_t count, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 256), [&](const auto& range) {
    for (std::size_t n = range.begin(); n != range.end(); ++n) body(n);
  });
}

// False when the list cannot be indexed safely by the other checks.
template <int N>
bool check_list(const BallSet& balls, const SimplexList<N>& list, bool with_values,
                const char* name, Findings& findings) {
  if (with_values &&
      (list.alpha_values.size() != list.size() || list.classes.size() != list.size())) {
    findings.fail(std::string(name) + ": alpha values or classes are not one per simplex");
    return false;
  }
  bool sound = true;
  for (std::size_t n = 0; n < list.size(); ++n) {
    const auto& s = list.simplices[n];
    const bool ascending =
        std::adjacent_find(s.begin(), s.end(), std::greater_equal<>()) == s.end();
    const bool good = s[N - 1] < balls.size() && ascending && (n == 0 || list.simplices[n - 1] < s);
    findings.check<N>(good, s, "vertices or list out of order, or no such ball");
    sound = sound && good;
  }
  return sound;
}

void check_tetrahedra(const BallSet& balls, const NearBalls& near, const SimplexList<4>& list,
                      double alpha, Findings& findings) {
  for_all(list.size(), [&](std::size_t n) {
    const auto& s = list.simplices[n];
    const TetrahedronConflict conflict(balls, s);
    findings.check<4>(!conflict.flat(), s, "flat tetrahedron");
    if (conflict.flat()) return;
    findings.check<4>(
        list.alpha_values.empty() || list.alpha_values[n] == ortho_radius_rounded(balls, s), s,
        "alpha value is not the ortho-radius");
    const bool within = compare_ortho_radius(balls, s, alpha) <= 0;
    findings.check<4>(within, s, "ortho-radius above alpha");
    if (!within) return;  // and then far balls might be in conflict, too
    findings.check<4>(
        !near.any(s[0], [&](BallIndex m) { return !contains<4>(s, m) && conflict(m); }), s,
        "a ball is in conflict with its orthosphere");
  });
}

template <int N>
void check_faces(const BallSet& balls, const NearBalls& near, const SimplexList<N>& list,
                 const SimplexList<N + 1>& cofaces, double alpha, Findings& findings) {
  const FaceGroups<N> groups(cofaces.simplices);
  std::vector<std::uint32_t> group_of(list.size(), ~std::uint32_t{0});
  for (std::uint32_t g = 0; g < groups.size(); ++g) {
    const auto& face = groups.faces()[g];
    const auto at = std::lower_bound(list.simplices.begin(), list.simplices.end(), face);
    const bool there = at != list.simplices.end() && *at == face;
    findings.check<N>(there, face, "face of a simplex of the complex, but not in it");
    if (there) group_of[static_cast<std::size_t>(at - list.simplices.begin())] = g;
  }
  for_all(list.size(), [&](std::size_t n) {
    const auto& s = list.simplices[n];
    const float value = list.alpha_values[n];
    float least = std::numeric_limits<float>::infinity();
    bool attached_to_coface = false;
    if (group_of[n] != ~std::uint32_t{0}) {
      groups.for_cofaces(group_of[n], [&](std::uint32_t c) {
        least = std::min(least, cofaces.alpha_values[c]);
        attached_to_coface =
            attached_to_coface ||
            conflict_with_smallest_orthosphere(balls, s, apex<N>(cofaces.simplices[c], s)) < 0;
      });
    }
    findings.check<N>(value <= least, s, "alpha value above that of a coface");
    if (attached_to_coface) {
      findings.check<N>(value == least, s, "attached, but alpha value not that of a coface");
      return;
    }
    findings.check<N>(value == ortho_radius_rounded(balls, s), s,
                      "unattached, but alpha value not the ortho-radius");
    const bool within = compare_ortho_radius(balls, s, alpha) <= 0;
    findings.check<N>(within, s, "ortho-radius above alpha");
    if (!within) return;
    const bool conflict = near.any(s[0], [&](BallIndex m) {
      return !contains<N>(s, m) && conflict_with_smallest_orthosphere(balls, s, m) < 0;
    });
    findings.check<N>(!conflict, s, "a ball is in conflict, but the apex of no coface");
  });
}

template <int N>
void check_classes(const SimplexList<N>& list, const SimplexList<N>& expected, Findings& findings) {
  for (std::size_t n = 0; n < list.size(); ++n) {
    findings.check<N>(list.classes[n] == expected.classes[n], list.simplices[n], "wrong class");
  }
}

double largest_value(const AlphaComplex& complex) {
  float largest = -std::numeric_limits<float>::max();
  const auto add = [&](const ResultArray<float>& values) {
    for (const float v : values) largest = std::max(largest, v);
  };
  add(complex.vertices.alpha_values);
  add(complex.edges.alpha_values);
  add(complex.triangles.alpha_values);
  add(complex.tetrahedra.alpha_values);
  return std::nextafter(largest, std::numeric_limits<float>::max());
}

template <int N>
bool is_sublist(const SimplexList<N>& smaller, const SimplexList<N>& larger) {
  return std::includes(larger.simplices.begin(), larger.simplices.end(), smaller.simplices.begin(),
                       smaller.simplices.end());
}

}  // namespace

Verification verify(const BallSet& balls, const AlphaComplex& complex) {
  Findings findings;
  const bool whole = !complex.tetrahedra_only;
  const double alpha = complex.alpha_on_lattice;
  bool sound = check_list(balls, complex.tetrahedra, whole, "tetrahedra", findings);
  sound = check_list(balls, complex.triangles, whole, "triangles", findings) && sound;
  sound = check_list(balls, complex.edges, whole, "edges", findings) && sound;
  sound = check_list(balls, complex.vertices, whole, "vertices", findings) && sound;
  if (!sound) return findings.take();

  const NearBalls near(balls, std::min(alpha, largest_value(complex)));
  check_tetrahedra(balls, near, complex.tetrahedra, alpha, findings);
  if (complex.tetrahedra_only) return findings.take();
  check_faces<3>(balls, near, complex.triangles, complex.tetrahedra, alpha, findings);
  check_faces<2>(balls, near, complex.edges, complex.triangles, alpha, findings);
  check_faces<1>(balls, near, complex.vertices, complex.edges, alpha, findings);

  Verification so_far = findings.take();
  if (!so_far.ok()) return so_far;  // classes of a complex that is not closed mean nothing
  Findings of_classes;
  AlphaComplex expected = complex;
  classify(expected);
  check_classes(complex.tetrahedra, expected.tetrahedra, of_classes);
  check_classes(complex.triangles, expected.triangles, of_classes);
  check_classes(complex.edges, expected.edges, of_classes);
  check_classes(complex.vertices, expected.vertices, of_classes);
  Verification classes = of_classes.take();
  classes.checks += so_far.checks;
  return classes;
}

bool is_subcomplex(const AlphaComplex& smaller, const AlphaComplex& larger) {
  return is_sublist(smaller.vertices, larger.vertices) && is_sublist(smaller.edges, larger.edges) &&
         is_sublist(smaller.triangles, larger.triangles) &&
         is_sublist(smaller.tetrahedra, larger.tetrahedra);
}

}  // namespace alphascope
