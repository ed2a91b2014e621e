// Numbers that cavities keep while alpha or the solvent radius slides, for what stays with them:
// colours, labels, what is chosen.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "core/cavity_identity/cavity_identity.hpp"

namespace alphascope {

struct CavityNumbers {
  std::shared_ptr<const CavityTable> table;
  std::vector<std::uint32_t> of;  // of each of found.cavities; no two are equal
  // Of every sink that a cavity had so far: one that comes back gets its number again.
  std::map<std::array<BallIndex, 4>, std::uint32_t> known;
  std::uint32_t used = 0;   // all numbers are below
  std::uint64_t steps = 0;  // next_numbers() since first_numbers()
  // What the last step did to each of found.cavities: the number of the cavity that it has parted
  // from, or kNone; and how many cavities have merged into it.
  std::vector<std::uint32_t> parted_from, merged;
  // Of cavities that are none of their own now, because they have merged into another one: the
  // number that this one had then.
  std::map<std::uint32_t, std::uint32_t> merged_into;

  // The cavity of a number, or CavityMatch::kNone.
  std::uint32_t cavity(std::uint32_t number) const;
  // The same, or the one that it has merged into.
  std::uint32_t cavity_or_heir(std::uint32_t number) const;
};

// By rows: 0 for the largest SA volume.
CavityNumbers first_numbers(std::shared_ptr<const CavityTable> table);

// A cavity that carries on an earlier one's identity keeps its number, another one gets the number
// that its sink had before, and if there is none or another cavity has it now, a new one. Of balls
// with other indices: first_numbers(). As match_cavities().
CavityNumbers next_numbers(const CavityNumbers& before, std::shared_ptr<const CavityTable> table,
                           const CancelToken& cancel = {});

}  // namespace alphascope
