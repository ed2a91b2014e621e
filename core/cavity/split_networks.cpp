// SPDX-License-Identifier: GPL-3.0-or-later
// Replaces networks by their parts and gives the parts all that a cavity has: mouths, passages,
// atoms, sinks.
#include "core/cavity/split_networks.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "core/cavity/bodies.hpp"
#include "core/cavity/inside.hpp"
#include "core/cavity/mouths.hpp"
#include "core/cavity/network_parting.hpp"
#include "core/cavity/tetrahedron_order.hpp"
#include "core/cavity/watershed.hpp"
#include "core/run/internal_error.hpp"
#include "core/triangulation/grouped.hpp"
#include "core/triangulation/indices_where.hpp"
#include "core/triangulation/membership.hpp"

namespace alphascope {
namespace {

class NetworkSplitter {
 public:
  NetworkSplitter(const CavityGround& ground, const Membership& membership, Cavities found,
                  const CancelToken& cancel)
      : ground_(ground), in_(membership), found_(std::move(found)), cancel_(cancel) {}

  Cavities split(const Alpha& alpha, OutsideRule rule, TriangulationMaker* maker) {
    const auto is_network = [](const Cavity& cavity) { return cavity.is_network(); };
    if (std::none_of(found_.cavities.begin(), found_.cavities.end(), is_network)) {
      return std::move(found_);
    }
    const Filtration filtration(ground_.balls, ground_.triangulation, RunContext{cancel_, {}},
                                maker);
    for (std::uint32_t c = 0; c < found_.cavities.size(); ++c) {
      if (!is_network(found_.cavities[c])) {
        kept_.push_back(std::move(found_.cavities[c]));
        continue;
      }
      const auto parting = part_network(ground_, filtration, in_, found_, c, alpha, rule, cancel_);
      if (parting && parting->descendants.size() > 1) {
        add_parts(c, *parting);
      } else {
        kept_.push_back(found_.cavities[c]);  // copied, because found_ is still read
      }
    }
    finish_parts();
    sort_networks();
    list_all();
    return std::move(found_);
  }

 private:
  void add_parts(std::uint32_t index, const NetworkParting& parting) {
    const Cavity& network = found_.cavities[index];
    const auto number = static_cast<std::uint32_t>(found_.networks.size());
    const std::size_t first = parts_.size();
    found_.networks.push_back({network.deepest_sink, network.mouths.size(),
                               network.tetrahedra.size(), parting.descendants.size(),
                               parting.alpha_angstrom2});
    parts_.resize(first + parting.descendants.size());
    const std::vector<std::uint32_t> part_of =
        watershed(ground_, in_, found_, index, parting, cancel_);
    for (std::size_t n = 0; n < part_of.size(); ++n) {
      if (part_of[n] == Cavities::kNone) throw InternalError("A network is not connected.");
      parts_[first + part_of[n]].tetrahedra.push_back(network.tetrahedra[n]);
    }
    for (std::size_t k = first; k < parts_.size(); ++k) parts_[k].network = number;
    bodies_wanted_ = bodies_wanted_ || network.bodies > 1;
  }

  // Sets the mouths, passages and all other members of the parts.
  void finish_parts() {
    constexpr std::uint32_t kNone = Cavities::kNone;
    std::vector<std::uint32_t> part_of(ground_.triangulation->tetrahedra.size(), kNone);
    for (std::uint32_t p = 0; p < parts_.size(); ++p) {
      for (const std::uint32_t t : parts_[p].tetrahedra) part_of[t] = p;
      list_atoms(parts_[p]);
      look_for_sinks(parts_[p]);
    }
    const auto& sides = ground_.incidence.tetrahedra_of_triangle;
    const auto parts_at = [&](std::uint32_t f) {
      const auto [a, b] = sides[f];
      return std::pair(part_of[a], b == Incidence::kOutside ? kNone : part_of[b]);
    };
    const ResultArray<std::uint32_t> triangles = indices_where(
        sides.size(),
        [&](std::size_t f) {
          const auto [of_a, of_b] = parts_at(static_cast<std::uint32_t>(f));
          return !in_.triangles[f] && of_a != of_b;
        },
        cancel_);
    std::vector<std::uint32_t> open, part_of_open;
    Passages passages;
    for (const std::uint32_t f : triangles) {
      const auto [of_a, of_b] = parts_at(f);
      if (of_a == kNone || of_b == kNone) {
        open.push_back(f);
        part_of_open.push_back(of_a != kNone ? of_a : of_b);
      } else {
        passages[std::minmax(of_a, of_b)].push_back(f);
      }
    }
    const Grouped opening = grouped(
        open, parts_.size(), [&](std::size_t n) { return part_of_open[n]; }, cancel_);
    set_mouths(ground_, in_, opening, parts_);
    add_passages(passages);
    if (bodies_wanted_) {
      UnionFind balls = joined_balls(ground_, in_, cancel_);
      for (Cavity& part : parts_) part.bodies = count_bodies(part, balls);
    } else {
      for (Cavity& part : parts_) part.bodies = part.atoms.empty() ? 0 : 1;
    }
  }

  // For each pair of parts the triangles between them. They are grouped as those of a mouth.
  using Passages = std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>>;
  void add_passages(const Passages& passages) {
    std::vector<std::uint32_t> all_triangles, passage_of;
    for (std::uint32_t n = 0; const auto& [pair, triangles] : passages) {
      all_triangles.insert(all_triangles.end(), triangles.begin(), triangles.end());
      passage_of.resize(all_triangles.size(), n++);
    }
    std::vector<Cavity> between(passages.size());
    set_mouths(
        ground_, in_,
        grouped(
            all_triangles, passages.size(), [&](std::size_t n) { return passage_of[n]; }, cancel_),
        between);
    std::size_t n = 0;
    for (const auto& [pair, triangles] : passages) {
      for (const std::uint32_t p : {pair.first, pair.second}) {
        auto& all = parts_[p].passages;
        all.insert(all.end(), between[n].mouths.begin(), between[n].mouths.end());
      }
      ++n;
    }
    for (Cavity& part : parts_) {
      std::sort(part.passages.begin(), part.passages.end(), [](const Mouth& a, const Mouth& b) {
        return a.triangles.front() < b.triangles.front();
      });
    }
  }

  void list_atoms(Cavity& part) const {
    for (const std::uint32_t t : part.tetrahedra) {
      for (const BallIndex v : ground_.triangulation->tetrahedra[t]) {
        if (in_.vertices[v]) part.atoms.push_back(v);
      }
    }
    std::sort(part.atoms.begin(), part.atoms.end());
    part.atoms.erase(std::unique(part.atoms.begin(), part.atoms.end()), part.atoms.end());
  }

  void look_for_sinks(Cavity& part) const {
    for (const std::uint32_t t : part.tetrahedra) {
      if (!ground_.flow.is_sink(t)) continue;
      if (part.sinks++ == 0 || is_deeper_sink(ground_, t, part.deepest_sink)) part.deepest_sink = t;
    }
    if (part.sinks == 0) throw InternalError("A part of a network has no sink.");
  }

  // Orders networks by the positions of their deepest sinks, so that the order of the balls does
  // not matter.
  void sort_networks() {
    std::vector<std::uint32_t> order(found_.networks.size()), place(order.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto& tetrahedra = ground_.triangulation->tetrahedra;
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return comes_first(*ground_.balls, tetrahedra[found_.networks[a].deepest_sink],
                         tetrahedra[found_.networks[b].deepest_sink]);
    });
    std::vector<SplitNetwork> sorted;
    for (std::uint32_t n = 0; n < order.size(); ++n) {
      sorted.push_back(found_.networks[order[n]]);
      place[order[n]] = n;
    }
    found_.networks = std::move(sorted);
    for (Cavity& part : parts_) part.network = place[part.network];
  }

  // Orders all cavities by their first tetrahedra, as find_cavities() does.
  void list_all() {
    for (Cavity& part : parts_) kept_.push_back(std::move(part));
    std::sort(kept_.begin(), kept_.end(), [](const Cavity& a, const Cavity& b) {
      return a.tetrahedra.front() < b.tetrahedra.front();
    });
    found_.cavities = std::move(kept_);
    for (std::uint32_t c = 0; c < found_.cavities.size(); ++c) {
      for (const std::uint32_t t : found_.cavities[c].tetrahedra) {
        found_.cavity_of_tetrahedron[t] = c;
      }
    }
  }

  const CavityGround& ground_;
  const Membership& in_;
  Cavities found_;
  const CancelToken& cancel_;
  std::vector<Cavity> kept_, parts_;
  bool bodies_wanted_ = false;  // whether a network lies between several bodies
};

}  // namespace

Cavities split_networks(const CavityGround& ground, const Membership& membership, Cavities found,
                        const Alpha& alpha_angstrom2, OutsideRule rule, const CancelToken& cancel,
                        TriangulationMaker* maker) {
  if (ground.triangulation->dimension < 3) return found;
  return NetworkSplitter(ground, membership, std::move(found), cancel)
      .split(alpha_angstrom2, rule, maker);
}

}  // namespace alphascope
