// SPDX-License-Identifier: GPL-3.0-or-later
// Assigns kinds in their order of precedence. ladders.hpp has the bridges.
#include "core/secondary/dssp.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/secondary/ladders.hpp"

namespace alphascope {
namespace {

using Kind = SecondaryStructure;

constexpr double kDegrees = 180 / std::numbers::pi;
// A bend: CA of two residues before, this one and two after turn by more.
constexpr double kBendDegrees = 70;
// Torsion angles of polyproline II, with their largest deviation; DSSP 4.
constexpr double kPhiDegrees = -75, kPsiDegrees = 145, kDeviationDegrees = 29;
constexpr int kPolyprolineResidues = 3;

double torsion_degrees(const RealPoint& a, const RealPoint& b, const RealPoint& c,
                       const RealPoint& d) {
  const RealPoint axis = c - b, u = cross(b - a, axis), v = cross(axis, d - c);
  return kDegrees * std::atan2(dot(cross(u, v), unit_vector(axis)), dot(u, v));
}

class Assignment {
 public:
  Assignment(const Molecule& molecule, const std::vector<BackboneResidue>& residues,
             const std::vector<HydrogenBonds>& bonds)
      : molecule_(molecule),
        residues_(residues),
        bonds_(bonds),
        size_(static_cast<int>(residues_.size())),
        kinds_(residues_.size(), Kind::coil) {
    int breaks = 0;
    for (const BackboneResidue& residue : residues_) {
      chain_of_.push_back(breaks);
      breaks += !residue.bound_to_next;
    }
  }

  std::vector<Kind> make() {
    set_ladders();
    for (int stride = 3; stride <= 5; ++stride) find_turns(stride);
    set_helices(4, Kind::alpha_helix, true);
    set_helices(3, Kind::three_ten_helix, false);
    set_helices(5, Kind::pi_helix, false);
    set_turns_and_bends();
    set_polyproline();
    return std::move(kinds_);
  }

 private:
  Kind& kind(int residue) { return kinds_[static_cast<std::size_t>(residue)]; }
  const BackboneResidue& at(int residue) const {
    return residues_[static_cast<std::size_t>(residue)];
  }
  RealPoint place(std::uint32_t atom) const { return position_angstrom(molecule_, atom); }
  bool in_one_chain(int first, int last) const {
    return first >= 0 && last < size_ &&
           chain_of_[static_cast<std::size_t>(first)] == chain_of_[static_cast<std::size_t>(last)];
  }

  void set_ladders() {
    for (const Ladder& ladder : find_ladders(bonds_, chain_of_)) {
      const Kind found = ladder.bridges > 1 ? Kind::strand : Kind::bridge;
      for (int k = ladder.i_first; k <= ladder.i_last; ++k) kind(k) = std::max(kind(k), found);
      for (int k = ladder.j_first; k <= ladder.j_last; ++k) kind(k) = std::max(kind(k), found);
    }
  }

  // An n-turn at a residue: its C=O is bonded to the N-H of the n-th residue behind it.
  void find_turns(int stride) {
    std::vector<bool>& turns = turns_[static_cast<std::size_t>(stride - 3)];
    turns.assign(residues_.size(), false);
    for (int k = 0; k + stride < size_; ++k) {
      turns[static_cast<std::size_t>(k)] =
          in_one_chain(k, k + stride) &&
          bonds_[static_cast<std::size_t>(k + stride)].accepts(static_cast<std::uint32_t>(k));
    }
  }
  bool turn(int residue, int stride) const {
    return residue >= 0 &&
           turns_[static_cast<std::size_t>(stride - 3)][static_cast<std::size_t>(residue)];
  }

  // Two consecutive n-turns make a helix of n residues behind the first. Alpha helices replace
  // strands, and pi helices replace alpha helices; 3-10 helices replace nothing.
  void set_helices(int stride, Kind helix, bool always) {
    for (int k = 1; k + stride < size_; ++k) {
      if (!turn(k, stride) || !turn(k - 1, stride)) continue;
      bool free = true;
      for (int m = k; m < k + stride; ++m) {
        free = free && (kind(m) == Kind::coil || kind(m) == helix ||
                        (helix == Kind::pi_helix && kind(m) == Kind::alpha_helix));
      }
      if (!always && !free) continue;
      for (int m = k; m < k + stride; ++m) kind(m) = helix;
    }
  }

  bool within_turn(int residue) const {
    for (int stride = 3; stride <= 5; ++stride) {
      for (int k = 1; k < stride; ++k) {
        if (turn(residue - k, stride)) return true;
      }
    }
    return false;
  }

  bool bends(int residue) const {
    if (!in_one_chain(residue - 2, residue + 2)) return false;
    const RealPoint here = place(at(residue).ca);
    const RealPoint from = unit_vector(here - place(at(residue - 2).ca)),
                    to = unit_vector(place(at(residue + 2).ca) - here);
    return kDegrees * std::acos(std::clamp(dot(from, to), -1.0, 1.0)) > kBendDegrees;
  }

  void set_turns_and_bends() {
    for (int k = 1; k + 1 < size_; ++k) {
      if (kind(k) != Kind::coil) continue;
      if (within_turn(k)) {
        kind(k) = Kind::turn;
      } else if (bends(k)) {
        kind(k) = Kind::bend;
      }
    }
  }

  bool has_polyproline_angles(int residue) const {
    if (!in_one_chain(residue - 1, residue + 1)) return false;
    const RealPoint n = place(at(residue).n), ca = place(at(residue).ca), c = place(at(residue).c);
    const double phi = torsion_degrees(place(at(residue - 1).c), n, ca, c);
    const double psi = torsion_degrees(n, ca, c, place(at(residue + 1).n));
    return std::fabs(phi - kPhiDegrees) <= kDeviationDegrees &&
           std::fabs(psi - kPsiDegrees) <= kDeviationDegrees;
  }

  void set_polyproline() {
    int run = 0;
    for (int k = 1; k + 1 < size_; ++k) {
      run = has_polyproline_angles(k) ? run + 1 : 0;
      if (run < kPolyprolineResidues) continue;
      for (int m = k - kPolyprolineResidues + 1; m <= k; ++m) {
        if (kind(m) == Kind::coil) kind(m) = Kind::polyproline;
      }
    }
  }

  const Molecule& molecule_;
  const std::vector<BackboneResidue>& residues_;
  const std::vector<HydrogenBonds>& bonds_;
  const int size_;
  std::vector<Kind> kinds_;
  std::vector<int> chain_of_;                 // breaks of the chain before each residue
  std::array<std::vector<bool>, 3> turns_{};  // of 3, 4 and 5 residues
};

}  // namespace

std::vector<SecondaryStructure> dssp(const Molecule& molecule,
                                     const std::vector<BackboneResidue>& residues,
                                     const std::vector<HydrogenBonds>& bonds) {
  return Assignment(molecule, residues, bonds).make();
}

}  // namespace alphascope
