// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers that cavities keep while alpha or the solvent radius changes. Colours, labels and the
// selection follow them.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "core/cavity_identity/cavity_identity.hpp"

namespace alphascope {

// The deepest sink of a cavity, and the cavity's number.
struct KnownSink {
  std::array<BallIndex, 4> sink;
  std::uint32_t number;
};

struct CavityNumbers {
  std::shared_ptr<const CavityTable> table;
  std::vector<std::uint32_t> of;  // for each of found.cavities; all are different
  // The number of every sink that a cavity had so far, ascending by sinks. A sink that comes back
  // gets its number again.
  std::vector<KnownSink> known;
  std::uint32_t used = 0;   // all numbers are below this
  std::uint64_t steps = 0;  // calls of next_numbers() since first_numbers()
  // The changes of the last step for each of found.cavities. `parted_from` is the number of the
  // cavity from which it parted, or kNone. `merged` is how many cavities merged into it.
  std::vector<std::uint32_t> parted_from, merged;
  // For each number whose cavity merged into another: the number of that other cavity at that time.
  std::map<std::uint32_t, std::uint32_t> merged_into;

  // The number of a sink in `known`, or CavityMatch::kNone.
  std::uint32_t number_of(const std::array<BallIndex, 4>& sink) const;
  // The index of the cavity with a number, or CavityMatch::kNone.
  std::uint32_t cavity(std::uint32_t number) const;
  // The same; if that cavity has merged, the one into which it merged.
  std::uint32_t cavity_or_heir(std::uint32_t number) const;
};

// Numbers go by rows: 0 for the largest SA volume.
CavityNumbers first_numbers(std::shared_ptr<const CavityTable> table);

// A cavity that is the same as an earlier one keeps its number. Another one gets the number that
// its sink had before. If there is none, or another cavity has it now, it gets a new number. If the
// number of balls differs, the result is that of first_numbers(). Threads and exceptions as
// match_cavities().
CavityNumbers next_numbers(const CavityNumbers& before, std::shared_ptr<const CavityTable> table,
                           const CancelToken& cancel = {});

}  // namespace alphascope
