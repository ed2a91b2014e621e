// SPDX-License-Identifier: GPL-3.0-or-later
// Searches the solvent radius at which a network falls apart: a guess from alpha, then strides and
// halving.
#include "core/cavity_identity/network_radius.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <stdexcept>
#include <utility>

#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/cavity/network_parting.hpp"
#include "core/cavity_identity/cavity_identity.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice.hpp"
#include "core/triangulation/membership.hpp"
#include "core/triangulation/triangulation_maker.hpp"

namespace alphascope {
namespace {

constexpr double kStepsPerAngstrom = 1 / kNetworkStepAngstrom;

double radius_of(int step) {
  return step / kStepsPerAngstrom;
}

class RadiusSearch {
 public:
  RadiusSearch(const BallSet& balls, const CavityTable& table, std::uint32_t cavity,
               const NetworkSearch& search, const RunContext& context)
      : balls_(balls), table_(table), cavity_(cavity), search_(search), context_(context) {
    const double solvent = table.question.solvent_radius_angstrom;
    first_ = static_cast<int>(std::floor(solvent * kStepsPerAngstrom));
    while (radius_of(first_) <= solvent) ++first_;
    last_ = first_ + static_cast<int>(kNetworkReachAngstrom * kStepsPerAngstrom) - 1;
  }

  NetworkEnd find() {
    context_.report(kNetworkStage, 0);
    end_.largest_radius_angstrom = radius_of(last_);
    part_by_alpha();
    const int step = first_without(std::clamp(guess(), first_, last_));
    const Left& left = at(step);
    if (left.networks > 0) return end_;
    end_.radius_angstrom = radius_of(step);
    end_.cavities = left.cavities;
    end_.largest_volume_sa_angstrom3 = left.largest_volume_sa_angstrom3;
    return end_;
  }

 private:
  // The cavities into which the network turns with another radius.
  struct Left {
    std::size_t networks = 0, cavities = 0;
    double largest_volume_sa_angstrom3 = 0;
  };

  bool is_network_at(int step) { return step < first_ || at(step).networks > 0; }

  // Returns a step at which no network is left, such that at the step before it one is. Goes from
  // the guess in strides that double, until it has a step of either kind, and then halves the
  // interval between them. Returns the last step if a network is left at all tested steps.
  int first_without(int guess) {
    int with = first_ - 1, without = guess;
    if (is_network_at(guess)) {
      with = guess;
      for (int stride = 1;; stride *= 2) {
        if (with == last_) return last_;
        without = std::min(with + stride, last_);
        if (!is_network_at(without)) break;
        with = without;
      }
    } else {
      for (int stride = 1;; stride *= 2) {
        with = std::max(without - stride, first_ - 1);
        if (is_network_at(with)) break;
        without = with;
      }
    }
    while (without - with > 1) {
      const int middle = with + (without - with) / 2;
      (is_network_at(middle) ? with : without) = middle;
    }
    return without;
  }

  RunContext quiet() const { return {context_.cancel, {}}; }

  void part_by_alpha() {
    const CavityGround& ground = *table_.ground;
    const CavityParameters& question = table_.question;
    const Membership in = membership(
        *ground.balls, *ground.triangulation, ground.incidence, ground.flow,
        ground.balls->lattice.alpha_on_lattice(question.alpha_angstrom2), context_.cancel);
    const Filtration filtration(ground.balls, ground.triangulation, quiet());
    const auto parting = part_network(ground, filtration, in, table_.found, cavity_,
                                      question.alpha_angstrom2, question.rule, context_.cancel);
    if (!parting) return;
    end_.alpha_angstrom2 = parting->alpha_angstrom2;
    end_.parts = parting->descendants.size();
  }

  // The solvent radius that enlarges a ball of mean radius as much as the change from the network's
  // alpha to that alpha does.
  int guess() const {
    if (!end_.alpha_angstrom2) return first_;
    const std::vector<BallIndex>& atoms = table_.found.cavities[cavity_].atoms;
    const Lattice& lattice = table_.ground->balls->lattice;
    double sum = 0;
    for (const BallIndex v : atoms) sum += lattice.angstrom(table_.ground->balls->radii[v]);
    if (atoms.empty()) return first_;
    const double radius = sum / static_cast<double>(atoms.size());
    const double grown = std::sqrt(radius * radius + end_.alpha_angstrom2->nearest() -
                                   table_.question.alpha_angstrom2.nearest());
    const double solvent = table_.question.solvent_radius_angstrom + grown - radius;
    return static_cast<int>(std::lround(std::min(solvent, radius_of(last_)) * kStepsPerAngstrom));
  }

  const Left& at(int step) {
    const auto known = known_.find(step);
    if (known != known_.end()) return known->second;
    constexpr double kUsual = 4;  // triangulations
    context_.report(kNetworkStage, (end_.triangulations + 1) / (end_.triangulations + 1 + kUsual));
    ++end_.triangulations;
    const double radius = radius_of(step);
    auto balls = std::make_shared<const BallSet>(with_solvent(balls_, radius));
    auto triangulation = std::make_shared<const Triangulation>(
        make_triangulation_by(search_.maker, *balls, search_.threads, quiet()));
    const auto ground = std::make_shared<const CavityGround>(make_cavity_ground(
        std::move(balls), std::move(triangulation), search_.ties, quiet(), search_.maker.get()));
    const CavityParameters question{table_.question.alpha_angstrom2, radius, table_.question.rule};
    const CavityTable there = make_cavity_table(ground, question, quiet(), search_.maker.get());
    const CavityMatch match = match_cavities(table_, there, context_.cancel);
    Left left;
    for (std::uint32_t c = 0; c < match.came_from.size(); ++c) {
      if (match.came_from[c] != cavity_) continue;
      ++left.cavities;
      left.networks += there.found.cavities[c].is_network();
      left.largest_volume_sa_angstrom3 =
          std::max(left.largest_volume_sa_angstrom3, there.measures[c].volume_sa_angstrom3);
    }
    return known_.emplace(step, left).first->second;
  }

  const BallSet& balls_;
  const CavityTable& table_;
  const std::uint32_t cavity_;
  const NetworkSearch search_;
  const RunContext& context_;
  int first_ = 0, last_ = 0;  // range of steps that may be tried
  std::map<int, Left> known_;
  NetworkEnd end_;
};

}  // namespace

NetworkEnd find_network_end(const BallSet& balls, const CavityTable& table, std::uint32_t cavity,
                            const NetworkSearch& search, const RunContext& context) {
  if (!table.found.cavities.at(cavity).is_network()) {
    throw std::invalid_argument("the cavity is no network");
  }
  return RadiusSearch(balls, table, cavity, search, context).find();
}

}  // namespace alphascope
