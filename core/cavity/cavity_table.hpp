// All cavities of one K_alpha with their numbers, in the order of a table.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/cavity/cavity_measures.hpp"

namespace alphascope {

struct CavityQuestion {
  Alpha alpha_angstrom2;
  double solvent_radius_angstrom = 0;  // within the radii of the ground's balls already
  OutsideRule rule = OutsideRule::castp;
  bool split_networks = false;  // networks are listed as their parts
  friend bool operator==(const CavityQuestion&, const CavityQuestion&) = default;
};

struct CavityTable {
  std::shared_ptr<const CavityGround> ground;
  CavityQuestion question;
  Cavities found;
  std::vector<CavityMeasures> measures;  // of found.cavities
  // Indices of found.cavities by falling SA volume: row 0 is CASTp's cavity 1.
  std::vector<std::uint32_t> order;

  std::size_t voids = 0, pockets = 0, mouths = 0;  // parts of networks count as pockets

  const Cavity& cavity(std::size_t row) const { return found.cavities[order[row]]; }
  const CavityMeasures& measure(std::size_t row) const { return measures[order[row]]; }
  std::size_t size() const { return order.size(); }
  // The balls of the deepest sink, ascending: what a cavity is known by.
  const std::array<BallIndex, 4>& sink(std::size_t row) const {
    return ground->triangulation->tetrahedra[cavity(row).deepest_sink];
  }
  // Sums over all voids, or all pockets.
  double volume_sa_angstrom3(bool of_voids) const;
  double area_sa_angstrom2(bool of_voids) const;
};

// What of a table takes longer, and may follow it: the exact volume and area of every cavity, in
// the order of found.cavities. Only pockets are clipped: of a void no ball pokes out, so that its
// sums are exact.
std::vector<ClippedMeasures> clip_all(const CavityTable& table, const RunContext& context = {});

// Is an SA volume too small to mean anything, or so far from the exact one that the difference must
// be shown? Below 1 Å³; more than a tenth.
bool is_doubtful(double sa_angstrom3, double exact_angstrom3);

// Of the balls of the ground. Works in the caller's task arena; the same for any number of threads.
// Throws Cancelled, and std::invalid_argument for an alpha that is no number.
CavityTable make_cavity_table(std::shared_ptr<const CavityGround> ground,
                              const CavityQuestion& question, const RunContext& context = {});

}  // namespace alphascope
