// SPDX-License-Identifier: GPL-3.0-or-later
// Finds bonds of chains by the distances of atoms.
#include "core/read/residues/chain_bonds.hpp"

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_point.hpp"

namespace alphascope {
namespace {

// Distances in Å. Bonds of a chain are 1.3 to 1.7 long; nothing else comes nearer than 2.
// Consecutive CA are 3.8 apart, or 2.9 across a cis bond.
constexpr double kNearest = 0.8, kBond = 2.0, kNextCa = 4.3, kNearestCa = 2.5;
constexpr Element kCarbon = 6, kNitrogen = 7, kOxygen = 8, kPhosphorus = 15;
// Limit of alternative residue types at one place, between a residue and its neighbour.
constexpr std::uint32_t kMostTypes = 4;

}  // namespace

std::size_t ChainBonds::KeyHash::operator()(const Key& key) const {
  std::uint64_t hash = (std::uint64_t{key.chain} << 32) ^ static_cast<std::uint32_t>(key.number);
  hash ^= std::uint64_t{key.segment} << 48;
  hash *= 0x9E3779B97F4A7C15u;
  return static_cast<std::size_t>(hash ^ (hash >> 29));
}

ChainBonds::ChainBonds(const Molecule& molecule, const ResidueTable& table)
    : molecule_(molecule), table_(table), piece_of_(table.residues.size()) {
  for (std::uint32_t k = 0; k < table.pieces.size(); ++k) piece_of_[table.pieces[k].residue] = k;
  const auto count = static_cast<std::uint32_t>(table.residues.size());
  for (std::uint32_t r = 0; r < count; ++r) {
    if (!table.residues[r].chain_like) continue;
    const Atom& atom = first(r);
    numbers_[{atom.chain, atom.segment, atom.residue_number}] = r;
    const std::uint32_t next = neighbour(r, true);
    any_ = any_ || (next != kNoIndex && bound(r, next));
  }
}

bool ChainBonds::is_bound(std::uint32_t r) const {
  const std::uint32_t after[] = {neighbour(r, true), by_number(r, 1)};
  const std::uint32_t before[] = {neighbour(r, false), by_number(r, -1)};
  for (const std::uint32_t next : after) {
    if (next != kNoIndex && table_.residues[next].chain_like && bound(r, next)) return true;
  }
  for (const std::uint32_t last : before) {
    if (last != kNoIndex && table_.residues[last].chain_like && bound(last, r)) return true;
  }
  return false;
}

bool ChainBonds::is_linked(std::uint32_t r) const {
  const std::uint32_t before = neighbour(r, false), after = neighbour(r, true);
  const auto chain = [&](std::uint32_t other) {
    return other != kNoIndex && table_.residues[other].chain_like;
  };
  if (!chain(before) && !chain(after)) return false;
  const auto near_one = [&](std::uint32_t atom, const std::array<std::uint32_t, 2>& ends) {
    for (const std::uint32_t end : ends) {
      if (end != kNoIndex && near(atom, end, kNearest, kBond)) return true;
    }
    return false;
  };
  const ResiduePiece& piece = table_.pieces[piece_of_[r]];
  for (std::size_t i = piece.begin; i < piece.end; ++i) {
    const auto atom = static_cast<std::uint32_t>(i);
    const Element element = molecule_.atoms[i].element;
    if (chain(before)) {
      const ResidueFacts& facts = table_.residues[before];
      if (element == kNitrogen && near_one(atom, facts.c)) return true;
      if (element == kPhosphorus && near_one(atom, facts.o3)) return true;
    }
    if (chain(after)) {
      const ResidueFacts& facts = table_.residues[after];
      if (element == kCarbon && near_one(atom, facts.n)) return true;
      if (element == kOxygen && near_one(atom, facts.p)) return true;
    }
  }
  return false;
}

bool ChainBonds::has_neighbour_by_number(std::uint32_t r) const {
  for (const int step : {-1, 1}) {
    const std::uint32_t other = by_number(r, step);
    if (other != kNoIndex &&
        table_.residues[other].record.section == table_.residues[r].record.section) {
      return true;
    }
  }
  return false;
}

bool ChainBonds::is_numbered_between(std::uint32_t r) const {
  const std::uint32_t before = neighbour(r, false), after = neighbour(r, true);
  const std::uint32_t section = table_.residues[r].record.section;
  return before != kNoIndex && after != kNoIndex && before == by_number(r, -1) &&
         after == by_number(r, 1) && table_.residues[before].record.section == section &&
         table_.residues[after].record.section == section;
}

bool ChainBonds::same_chain(std::uint32_t a, std::uint32_t b) const {
  return first(a).chain == first(b).chain && first(a).segment == first(b).segment;
}

std::uint32_t ChainBonds::neighbour(std::uint32_t r, bool after) const {
  const Atom& atom = first(r);
  std::uint32_t other = r;
  for (std::uint32_t step = 0; step < kMostTypes; ++step) {
    if (after ? other + 1 >= table_.residues.size() : other == 0) return kNoIndex;
    other = after ? other + 1 : other - 1;
    if (!same_chain(r, other)) return kNoIndex;
    if (!same_residue_number(atom, first(other))) return other;
  }
  return kNoIndex;
}

std::uint32_t ChainBonds::by_number(std::uint32_t r, int step) const {
  const Atom& atom = first(r);
  const auto found =
      numbers_.find({atom.chain, atom.segment,
                     static_cast<std::int32_t>(std::int64_t{atom.residue_number} + step)});
  return found == numbers_.end() ? kNoIndex : found->second;
}

bool ChainBonds::bound(std::uint32_t before, std::uint32_t after) const {
  const ResidueFacts &a = table_.residues[before], &b = table_.residues[after];
  if (any_near(a.c, b.n, kBond) || any_near(a.o3, b.p, kBond)) return true;
  return a.only_ca() && b.only_ca() && near(a.ca[0], b.ca[0], kNearestCa, kNextCa);
}

bool ChainBonds::any_near(const std::array<std::uint32_t, 2>& a,
                          const std::array<std::uint32_t, 2>& b, double most) const {
  for (const std::uint32_t i : a) {
    for (const std::uint32_t k : b) {
      if (i != kNoIndex && k != kNoIndex && near(i, k, kNearest, most)) return true;
    }
  }
  return false;
}

bool ChainBonds::near(std::uint32_t a, std::uint32_t b, double least, double most) const {
  const LatticePoint &p = molecule_.atoms[a].position, &q = molecule_.atoms[b].position;
  const double unit = molecule_.lattice.unit_angstrom();
  const double x = (double(p.x) - q.x) * unit, y = (double(p.y) - q.y) * unit,
               z = (double(p.z) - q.z) * unit;
  const double square = x * x + y * y + z * z;
  return square >= least * least && square <= most * most;
}

}  // namespace alphascope
