#include "core/geometry/coincident.hpp"

#include <cstdint>

namespace alphascope {
namespace {

std::uint64_t centre_hash(const LatticePoint& p) {
  std::uint64_t h = static_cast<std::uint32_t>(p.x);
  h = (h ^ (static_cast<std::uint64_t>(static_cast<std::uint32_t>(p.y)) << 24)) *
      0x9e3779b97f4a7c15u;
  h = (h ^ (h >> 29) ^ static_cast<std::uint32_t>(p.z)) * 0xbf58476d1ce4e5b9u;
  return h ^ (h >> 32);
}

}  // namespace

// Open addressing with the centre as the key; each entry holds the visible ball at that centre.
std::vector<bool> coincident_hidden(const BallSet& balls) {
  constexpr BallIndex kEmpty = ~BallIndex{0};
  std::size_t capacity = 16;
  while (capacity < 2 * balls.size()) capacity *= 2;
  std::vector<BallIndex> table(capacity, kEmpty);
  std::vector<bool> hidden;
  for (BallIndex i = 0; i < balls.size(); ++i) {
    std::size_t at = centre_hash(balls.centres[i]) & (capacity - 1);
    while (table[at] != kEmpty && balls.centres[table[at]] != balls.centres[i]) {
      at = (at + 1) & (capacity - 1);
    }
    if (table[at] == kEmpty) {
      table[at] = i;
      continue;
    }
    if (hidden.empty()) hidden.assign(balls.size(), false);
    const bool wins = balls.radii[i] > balls.radii[table[at]];
    hidden[wins ? table[at] : i] = true;
    if (wins) table[at] = i;
  }
  return hidden;
}

}  // namespace alphascope
