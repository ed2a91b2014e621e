// SPDX-License-Identifier: GPL-3.0-or-later
// Names of a molecule's atoms, residues and chains. Each is stored once and known by a number, so
// that an atom stays small.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace alphascope {

using NameId = std::uint32_t;

class NameTable {
 public:
  NameTable() : texts_{""}, ids_{{"", 0}} {}  // id 0 is the empty name

  // Characters that cannot be shown are stored as printable() writes them.
  NameId intern(std::string_view text);

  // Valid as long as the table. `id` must come from intern() of this table, or of the one it was
  // copied from.
  std::string_view text(NameId id) const { return texts_[id]; }

  // The id of a text in the table; 0 if it is not there.
  NameId find(std::string_view text) const;

  std::size_t size() const { return texts_.size(); }

 private:
  // A cache by the first eight bytes, because files repeat a few hundred short names.
  struct Recent {
    std::uint64_t key = 0;
    NameId id = 0;
  };
  std::vector<std::string> texts_;
  std::unordered_map<std::string, NameId> ids_;
  std::array<Recent, 512> recent_{};
};

}  // namespace alphascope
