// SPDX-License-Identifier: GPL-3.0-or-later
// Collects facts on a simplex from the lists of a complex.
#include "core/document/explain/simplex_details.hpp"

#include <algorithm>

#include "core/complex/own_dimension.hpp"
#include "core/document/store/definition.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/key.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/measure/angles.hpp"
#include "core/molecule/name_table.hpp"
#include "core/radii/radii_set.hpp"
#include "core/run/cancel_token.hpp"
#include "core/triangulation/memory_need.hpp"

namespace alphascope {
namespace {

using Balls = std::vector<BallIndex>;

// Number of the balls that are corners of the simplex.
template <std::size_t N>
std::size_t common(const std::array<BallIndex, N>& simplex, const Balls& balls) {
  std::size_t found = 0;
  for (const BallIndex ball : balls) {
    found += std::find(simplex.begin(), simplex.end(), ball) != simplex.end();
  }
  return found;
}

class Finder {
 public:
  Finder(const BallSet& balls, const AlphaComplex& complex, const Balls& simplex,
         const RunContext& context)
      : balls_(balls), complex_(complex), context_(context) {
    details_.balls = simplex;
  }

  SimplexDetails find() {
    visit(complex_.vertices);
    visit(complex_.edges);
    visit(complex_.triangles);
    visit(complex_.tetrahedra);
    std::sort(ends_.begin(), ends_.end());
    ends_.erase(std::unique(ends_.begin(), ends_.end()), ends_.end());
    const LatticePoint& centre = balls_.centres[details_.balls[0]];
    for (const BallIndex end : ends_) {
      details_.neighbours.push_back(
          {end, balls_.lattice.angstrom(distance_on_lattice(centre, balls_.centres[end]))});
    }
    std::sort(details_.neighbours.begin(), details_.neighbours.end(),
              [](const NeighbourBall& a, const NeighbourBall& b) {
                return std::pair(a.distance_angstrom, a.ball) <
                       std::pair(b.distance_angstrom, b.ball);
              });
    return std::move(details_);
  }

 private:
  template <int N>
  void visit(const SimplexList<N>& list) {
    context_.cancel.throw_if_cancelled();
    const std::size_t size = details_.balls.size(), n = N;
    for (std::size_t i = 0; i < list.size(); ++i) {
      const auto& simplex = list.simplices[i];
      const std::size_t shared = common(simplex, details_.balls);
      if (shared == size && n == size) take_itself(list, i);
      if (shared == size && n > size) take_coface(simplex);
      const bool shares_face = n == 4 && size == 4 && shared == 3;
      if (shares_face || (shared == size && size > 1 && n == size + 1)) list_beside(simplex);
    }
  }

  template <int N>
  void take_itself(const SimplexList<N>& list, std::size_t i) {
    details_.in_complex = true;
    if (i < list.alpha_values.size()) {
      details_.alpha_value_angstrom2 = complex_.lattice.square_angstrom(list.alpha_values[i]);
    }
    if (i < list.classes.size()) details_.simplex_class = list.classes[i];
  }

  template <std::size_t N>
  void take_coface(const std::array<BallIndex, N>& simplex) {
    details_.in_complex = true;
    ++details_.cofaces[N - 1];
    const bool has_ends = N == 2 || complex_.tetrahedra_only;
    if (details_.balls.size() > 1 || !has_ends) return;
    for (const BallIndex ball : simplex) {
      if (ball != details_.balls[0]) ends_.push_back(ball);
    }
  }

  template <std::size_t N>
  void list_beside(const std::array<BallIndex, N>& simplex) {
    if (details_.beside.size() < SimplexDetails::kMostListed) {
      details_.beside.emplace_back(simplex.begin(), simplex.end());
    }
  }

  const BallSet& balls_;
  const AlphaComplex& complex_;
  const RunContext& context_;
  SimplexDetails details_;
  Balls ends_;
};

}  // namespace

SimplexDetails find_details(const BallSet& balls, const AlphaComplex& complex,
                            const std::vector<BallIndex>& simplex, const RunContext& context) {
  const InOwnDimension own(balls, complex);
  return Finder(balls, own.complex(), simplex, context).find();
}

Definition<SimplexDetails> simplex_details(const std::vector<BallIndex>& simplex) {
  return {{.id = "details",
           .title = "Surroundings of a simplex",
           .key =
               [simplex](const Inputs& in) {
                 if (!in.complex) return Key{};
                 Key key = key_of_complex(in);
                 for (const BallIndex ball : simplex) {
                   key.more = Key{key.more + 1, ball, 0}.number();
                 }
                 return key;
               },
           .memory =
               [](const Inputs&) {
                 return MemoryNeed{100'000, 1'000'000};
               },
           .lane = Lane::interactive},
          [simplex](const Inputs& in, const RunContext& context) {
            return std::make_shared<const SimplexDetails>(
                find_details(*in.balls, *in.complex, simplex, context));
          }};
}

}  // namespace alphascope
