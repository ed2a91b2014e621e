// SPDX-License-Identifier: GPL-3.0-or-later
// Keys of inputs, and the results that inputs carry.
#include "core/document/store/inputs.hpp"

#include <bit>
#include <string>

#include "core/complex/alpha_complex.hpp"
#include "core/document/store/key.hpp"
#include "core/molecule/name_table.hpp"
#include "core/radii/radii_set.hpp"
#include "core/run/internal_error.hpp"

namespace alphascope {
namespace {

// Spreads each bit over all bits (Steele, Lea, Flood: "Fast splittable pseudorandom number
// generators", OOPSLA 2014).
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

}  // namespace

const std::shared_ptr<const void>& Inputs::find(std::string_view id) const {
  for (const auto& [name, value] : made) {
    if (name == id) return value;
  }
  throw InternalError("A derived result asks for \"" + std::string(id) +
                      "\", which its definition does not name.");
}

std::uint64_t Key::number() const {
  return mixed(mixed(mixed(balls) + alpha) + more);
}

Key key_of_balls(const Inputs& inputs) {
  return {inputs.balls_key, 0, 0};
}

Key key_of_balls_and_alpha(const Inputs& inputs) {
  // Bits of 0 would mean that the key has no alpha. Only -0 would give them here, and adding 0
  // turns it into +0.
  constexpr std::uint64_t kSign = std::uint64_t{1} << 63;
  const Alpha& alpha = inputs.alpha_angstrom2;
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(alpha.nearest() + 0.0) ^ kSign;
  // Several decimals may share their nearest double. Their digits tell them apart.
  if (!alpha.is_decimal() || alpha.is_shortest_of_double()) return {inputs.balls_key, bits, 0};
  const auto whole = static_cast<std::uint64_t>(alpha.whole());
  const auto fraction = static_cast<std::uint64_t>(alpha.fraction());
  return {inputs.balls_key, mixed(mixed(mixed(bits) + whole) + fraction) | 1, 0};
}

Key key_of_complex(const Inputs& inputs) {
  if (!inputs.complex) return {};
  Key key = key_of_balls_and_alpha(inputs);
  key.more = inputs.complex->tetrahedra_only ? 1 : 2;
  return key;
}

// Two valid keys of the same inputs have the same balls, and the same alpha where both use it.
Key joined(const Key& a, const Key& b) {
  if (!a || !b) return {};
  const bool one_more = a.more == 0 || b.more == 0 || a.more == b.more;
  return {a.balls, a.alpha | b.alpha, one_more ? a.more | b.more : mixed(mixed(a.more) + b.more)};
}

}  // namespace alphascope
