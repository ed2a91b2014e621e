// SPDX-License-Identifier: GPL-3.0-or-later
// Finds by distances which residues of a model are bound in a chain. Bonds are C to N and O3' to P,
// or CA to CA where a model has nothing else.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "core/read/residues/residue_table.hpp"

namespace alphascope {

// The table must live longer.
class ChainBonds {
 public:
  ChainBonds(const Molecule& molecule, const ResidueTable& table);

  // True when a residue with backbone atoms is bound to a neighbour in the file or by number.
  bool is_bound(std::uint32_t residue) const;
  // The same for a residue with other atom names, by any nitrogen, carbon, phosphorus or oxygen in
  // it.
  bool is_linked(std::uint32_t residue) const;
  // True when the residue numbered one before or after it can belong to a chain. Both must be in
  // the same chain, with no TER between.
  bool has_neighbour_by_number(std::uint32_t residue) const;
  // True when both numbered neighbours are there, next to it in the file.
  bool is_numbered_between(std::uint32_t residue) const;

  // True when the file has any bond by distance. Files made by hand have none.
  bool any() const { return any_; }

 private:
  struct Key {
    NameId chain;
    std::uint16_t segment;
    std::int32_t number;
    bool operator==(const Key&) const = default;
  };
  struct KeyHash {
    std::size_t operator()(const Key& key) const;
  };
  const Atom& first(std::uint32_t residue) const {
    return molecule_.atoms[table_.residues[residue].first];
  }
  bool same_chain(std::uint32_t a, std::uint32_t b) const;
  // The next residue with another number in the file, in the same chain. kNoIndex if there is none.
  std::uint32_t neighbour(std::uint32_t residue, bool after) const;
  std::uint32_t by_number(std::uint32_t residue, int step) const;
  bool bound(std::uint32_t before, std::uint32_t after) const;
  bool near(std::uint32_t a, std::uint32_t b, double least, double most) const;
  bool any_near(const std::array<std::uint32_t, 2>& a, const std::array<std::uint32_t, 2>& b,
                double most) const;

  const Molecule& molecule_;
  const ResidueTable& table_;
  std::unordered_map<Key, std::uint32_t, KeyHash> numbers_;
  std::vector<std::uint32_t> piece_of_;  // the last piece of each residue
  bool any_ = false;
};

}  // namespace alphascope
