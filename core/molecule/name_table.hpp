// Strings of a molecule (atom, residue and chain names), each stored once and known by a number, so
// that an atom stays small whatever the length of its names.
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

  // What a name has of characters that cannot be shown is kept as printable() has it.
  NameId intern(std::string_view text);

  // Valid as long as the table; ids come from intern() of the same table or of a copy's original.
  std::string_view text(NameId id) const { return texts_[id]; }

  // The id of a text that is in the table, else 0.
  NameId find(std::string_view text) const;

  std::size_t size() const { return texts_.size(); }

 private:
  // Short names are looked up by their eight bytes first: files repeat a few hundred of them.
  struct Recent {
    std::uint64_t key = 0;
    NameId id = 0;
  };
  std::vector<std::string> texts_;
  std::unordered_map<std::string, NameId> ids_;
  std::array<Recent, 512> recent_{};
};

}  // namespace alphascope
