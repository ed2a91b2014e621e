// SPDX-License-Identifier: GPL-3.0-or-later
// Colours of atoms, in pictures and in files for other programs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/molecule/element.hpp"
#include "core/molecule/rgb8.hpp"
#include "core/molecule/secondary_structure.hpp"

namespace alphascope {

struct Molecule;

Rgb8 element_colour(Element element);
// The colour of the n-th chain. The first colours differ most. They repeat after kChainColours.
Rgb8 chain_colour(std::size_t n);
inline constexpr std::size_t kChainColours = 24;
// Of helices, and of strands and bridges. Other kinds have no colour of their own.
std::optional<Rgb8> secondary_colour(SecondaryStructure kind);

// The colour of each ball's element. `atom_of_ball` as in PreparedBalls: for each ball an index
// into the molecule's atoms.
std::vector<Rgb8> colours_by_element(const Molecule& molecule,
                                     const std::vector<std::uint32_t>& atom_of_ball);
}  // namespace alphascope
