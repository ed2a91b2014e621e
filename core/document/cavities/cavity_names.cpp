// SPDX-License-Identifier: GPL-3.0-or-later
// Names cavities by their sinks, collects lining residues, and writes sentences on mouths and
// networks.
#include "core/document/cavities/cavity_names.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "core/cavity/cavities.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/cavity_identity/network_radius.hpp"
#include "core/document/reference/reference.hpp"
#include "core/geometry/shortest_number.hpp"
#include "core/selection/atom_address.hpp"
#include "core/selection/atom_groups.hpp"
#include "core/selection/prepare_balls.hpp"
#include "core/text/grouped_number.hpp"

namespace alphascope {
namespace {

std::size_t atom_of(const BallReferences& references, BallIndex ball) {
  return references.prepared().atom_of_ball.at(ball);
}

// Calls use(atom, ball, begins_residue) for each ball of the lining.
template <class Use>
void for_lining(const BallReferences& references, std::span<const BallIndex> lining,
                const Use& use) {
  const std::vector<Atom>& atoms = references.molecule().atoms;
  const Atom* last = nullptr;
  for (const BallIndex ball : lining) {
    const std::size_t index = atom_of(references, ball);
    use(index, ball, !last || !same_residue(*last, atoms[index]));
    last = &atoms[index];
  }
}

}  // namespace

std::string cavity_name(const BallReferences& references, const CavityTable& table,
                        std::size_t row) {
  return sink_name(references, table.sink(row));
}

std::string sink_name(const BallReferences& references, std::span<const BallIndex> sink) {
  std::string text;
  for (const BallIndex ball : sink) {
    text +=
        (text.empty() ? "" : " ") + atom_address(references.molecule(), atom_of(references, ball));
  }
  return text;
}

SimplexRef cavity_sink(const BallReferences& references, const CavityTable& table,
                       std::size_t row) {
  return std::get<SimplexRef>(references.reference(table.sink(row)));
}

std::vector<LiningResidue> lining_residues(const BallReferences& references,
                                           const CavityTable& table, std::size_t row) {
  return residues_of_lining(references, table.measure(row).lining);
}

std::vector<LiningResidue> residues_of_lining(const BallReferences& references,
                                              std::span<const BallIndex> lining) {
  std::vector<LiningResidue> residues;
  for_lining(references, lining, [&](std::size_t atom, BallIndex ball, bool next) {
    if (next) residues.push_back({residue_address(references.molecule(), atom), {}});
    residues.back().balls.push_back(ball);
  });
  return residues;
}

LiningCounts lining_counts(const BallReferences& references, const CavityTable& table,
                           std::size_t row) {
  const std::vector<Atom>& atoms = references.molecule().atoms;
  std::vector<std::pair<NameId, std::size_t>> chains;  // chains with their numbers of residues
  LiningCounts counts;
  for_lining(references, table.measure(row).lining, [&](std::size_t atom, BallIndex, bool next) {
    if (!next) return;
    ++counts.residues;
    const NameId chain = atoms[atom].chain;
    auto at = std::find_if(chains.begin(), chains.end(),
                           [&](const auto& one) { return one.first == chain; });
    if (at == chains.end()) at = chains.insert(at, {chain, 0});
    ++at->second;
  });
  counts.chains = chains.size();
  std::size_t most = 0;
  for (const auto& [chain, residues] : chains) {
    counts.of_second = std::max(counts.of_second, std::min(most, residues));
    most = std::max(most, residues);
  }
  return counts;
}

std::string mouths_text(std::size_t mouths) {
  if (mouths < 2) return {};
  const std::string has = "It has " + grouped(mouths) + " mouths: ";
  if (mouths < Cavity::kMouthsOfNetwork) {
    return has + "it may be a pore. The page Channels says how wide it is.";
  }
  return has +
         "it is a network of gaps that are connected, rather than one hole. With a larger solvent "
         "radius it falls apart.";
}

std::string falls_apart_text(const NetworkEnd& end, double solvent_radius_angstrom) {
  const auto cavities = [](std::size_t n) {
    return n == 0 ? std::string("no cavity") : counted(n, "cavity", "cavities");
  };
  std::string text;
  if (end.radius_angstrom) {
    char largest[40];
    std::snprintf(largest, sizeof largest, "%.0f", end.largest_volume_sa_angstrom3);
    text = "At a solvent radius of " + shortest_number(*end.radius_angstrom) +
           " Å the network has fallen apart: " + cavities(end.cavities) + " left" +
           (end.cavities > 0 ? std::string(", the largest of ") + largest + " Å³." : ".");
    const double before = *end.radius_angstrom - kNetworkStepAngstrom;
    if (before > solvent_radius_angstrom) {
      text += " At " + shortest_number(std::round(before / kNetworkStepAngstrom) / 10) +
              " Å it has not.";
    }
  } else {
    text = "At a solvent radius of " + shortest_number(end.largest_radius_angstrom) +
           " Å a network still remains.";
  }
  if (end.alpha_angstrom2) {
    text += " With this solvent radius it falls apart at alpha " +
            shortest_number(*end.alpha_angstrom2) + " Å², with " + cavities(end.parts) + ".";
  }
  return text;
}

}  // namespace alphascope
