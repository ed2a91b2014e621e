// SPDX-License-Identifier: GPL-3.0-or-later
// Computes the words of selections that depend on several atoms.
#include "core/selection/selection_masks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/molecule/atom_type.hpp"
#include "core/neighbours/uniform_grid.hpp"
#include "core/predicates/wide_int.hpp"
#include "core/selection/atom_groups.hpp"

namespace alphascope {
namespace {

// Calls `use(begin, end)` for the atoms of each residue. They are consecutive in the file and in
// one model.
template <class Use>
void for_each_residue(const Molecule& molecule, const Use& use) {
  for (const ModelRange& model : molecule.models) {
    std::size_t begin = model.begin;
    for (std::size_t i = model.begin; i < model.end; ++i) {
      const bool last =
          i + 1 == model.end || !same_residue(molecule.atoms[i], molecule.atoms[i + 1]);
      if (!last) continue;
      use(begin, i + 1);
      begin = i + 1;
    }
  }
}

enum class Polymer : std::uint8_t { none, protein, nucleic };

Polymer polymer_of(const Molecule& molecule, std::size_t begin, std::size_t end) {
  if (molecule.atoms[begin].kind != ResidueKind::polymer) return Polymer::none;
  const std::string_view residue = molecule.text(molecule.atoms[begin].residue_name);
  if (!standard_amino_acid(residue).empty()) return Polymer::protein;
  if (nucleotide_base(residue) != 0) return Polymer::nucleic;
  bool n = false, ca = false;
  for (std::size_t i = begin; i < end; ++i) {
    const std::string_view name = molecule.text(molecule.atoms[i].name);
    if (name == "C1'" || name == "C1*") return Polymer::nucleic;
    n |= name == "N";
    ca |= name == "CA";
  }
  return n && ca ? Polymer::protein : Polymer::none;
}

bool is_backbone(Polymer polymer, std::string_view name) {
  constexpr std::string_view kProtein[] = {"N",  "CA", "C",  "O",   "OXT", "H",   "HN",  "H1",
                                           "H2", "H3", "HA", "HA2", "HA3", "1HA", "2HA", "HXT"};
  constexpr std::string_view kPhosphate[] = {"P", "OP1", "OP2", "OP3", "O1P", "O2P", "O3P"};
  const auto is = [name](std::string_view other) { return name == other; };
  if (polymer == Polymer::protein) {
    return std::any_of(std::begin(kProtein), std::end(kProtein), is);
  }
  const bool sugar = name.find('\'') != std::string_view::npos || name.ends_with('*');
  return sugar || std::any_of(std::begin(kPhosphate), std::end(kPhosphate), is);
}

// The largest square distance in square lattice units that is at most the square of `microangstrom`
// (10^-6 Å).
std::uint64_t most_square_units(std::int64_t microangstrom, const Lattice& lattice) {
  UInt128 square = static_cast<UInt128>(microangstrom) * static_cast<UInt128>(microangstrom);
  for (int digits = lattice.digits; digits < kMaxLatticeDigits; ++digits) square /= 100;
  constexpr auto kMost = std::numeric_limits<std::uint64_t>::max();
  return square > kMost ? kMost : static_cast<std::uint64_t>(square);
}

// Differences of coordinates fit into 31 bits, so the sum of their squares fits into 63.
std::uint64_t square_distance(const LatticePoint& p, std::int32_t x, std::int32_t y,
                              std::int32_t z) {
  const auto square = [](std::int32_t a, std::int32_t b) {
    const std::int64_t d = std::int64_t{a} - b;
    return static_cast<std::uint64_t>(d * d);
  };
  return square(p.x, x) + square(p.y, y) + square(p.z, z);
}

// Tests whether a point is near the centre of any ball.
class NearSome {
 public:
  NearSome(const BallSet& around, std::uint64_t most_square)
      : grid_(make_uniform_grid(around, 0, {})),
        most_(most_square),
        reach_(std::ceil(std::sqrt(static_cast<double>(most_square)) / grid_.cell_width)) {}

  bool operator()(const LatticePoint& p) const {
    int low[3], high[3];
    const int counts[3] = {grid_.nx, grid_.ny, grid_.nz};
    const double at[3] = {double(p.x) - grid_.origin.x, double(p.y) - grid_.origin.y,
                          double(p.z) - grid_.origin.z};
    for (int k = 0; k < 3; ++k) {
      const double cell = std::floor(at[k] / grid_.cell_width);
      low[k] = static_cast<int>(std::max(0.0, cell - reach_));
      high[k] = static_cast<int>(std::min(counts[k] - 1.0, cell + reach_));
      if (low[k] > high[k]) return false;
    }
    for (int x = low[0]; x <= high[0]; ++x) {
      for (int y = low[1]; y <= high[1]; ++y) {
        const std::size_t row = (static_cast<std::size_t>(x) * grid_.ny + y) * grid_.nz;
        const std::size_t end = grid_.cell_start[row + high[2] + 1];
        for (std::size_t s = grid_.cell_start[row + low[2]]; s < end; ++s) {
          if (square_distance(p, grid_.x[s], grid_.y[s], grid_.z[s]) <= most_) return true;
        }
      }
    }
    return false;
  }

 private:
  UniformGrid grid_;
  std::uint64_t most_;
  double reach_;  // number of cells, mostly 1
};

}  // namespace

std::vector<bool> atoms_of_polymers(const Molecule& molecule, SelectionTest which) {
  std::vector<bool> atoms(molecule.atoms.size());
  for_each_residue(molecule, [&](std::size_t begin, std::size_t end) {
    const Polymer polymer = polymer_of(molecule, begin, end);
    if (polymer == Polymer::none) return;
    for (std::size_t i = begin; i < end; ++i) {
      const bool backbone = is_backbone(polymer, molecule.text(molecule.atoms[i].name));
      atoms[i] = which == SelectionTest::protein    ? polymer == Polymer::protein
                 : which == SelectionTest::nucleic  ? polymer == Polymer::nucleic
                 : which == SelectionTest::backbone ? backbone
                                                    : !backbone;
    }
  });
  return atoms;
}

std::vector<bool> atoms_within(const Molecule& molecule, const std::vector<bool>& around,
                               std::int64_t microangstrom) {
  std::vector<bool> atoms(molecule.atoms.size());
  const std::uint64_t most = most_square_units(microangstrom, molecule.lattice);
  // Balls of half the distance make the grid's cells about as wide as the distance.
  const double half = std::min(std::ceil(std::sqrt(static_cast<double>(most)) / 2) + 1,
                               static_cast<double>(kMaxLatticeRadius));
  for (const ModelRange& model : molecule.models) {
    BallSet balls;
    balls.lattice = molecule.lattice;
    for (std::size_t i = model.begin; i < model.end; ++i) {
      if (around[i]) balls.centres.push_back(molecule.atoms[i].position);
    }
    if (balls.centres.empty()) continue;
    balls.radii.assign(balls.size(), static_cast<std::int32_t>(half));
    const NearSome near(balls, most);
    for (std::size_t i = model.begin; i < model.end; ++i) {
      atoms[i] = near(molecule.atoms[i].position);
    }
  }
  return atoms;
}

std::vector<bool> whole_residues(const Molecule& molecule, std::vector<bool> atoms) {
  for_each_residue(molecule, [&](std::size_t begin, std::size_t end) {
    const auto first = atoms.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto last = atoms.begin() + static_cast<std::ptrdiff_t>(end);
    if (std::find(first, last, true) != last) std::fill(first, last, true);
  });
  return atoms;
}

std::vector<bool> whole_chains(const Molecule& molecule, const std::vector<bool>& atoms) {
  std::vector<bool> result(atoms.size());
  for (const ModelRange& model : molecule.models) {
    std::vector<bool> chains(molecule.names.size());
    for (std::size_t i = model.begin; i < model.end; ++i) {
      if (atoms[i]) chains[molecule.atoms[i].chain] = true;
    }
    for (std::size_t i = model.begin; i < model.end; ++i) {
      result[i] = chains[molecule.atoms[i].chain];
    }
  }
  return result;
}

}  // namespace alphascope
