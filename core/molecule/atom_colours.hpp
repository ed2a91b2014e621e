// The colours that atoms have in pictures and in files for other programs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/molecule/molecule.hpp"
#include "core/molecule/rgb8.hpp"

namespace alphascope {

Rgb8 element_colour(Element element);
// Of the n-th chain; the first ones differ the most. Repeats after kChainColours.
Rgb8 chain_colour(std::size_t n);
inline constexpr std::size_t kChainColours = 24;

// `atom_of_ball` as in PreparedBalls: an index into the molecule's atoms for each ball.
std::vector<Rgb8> colours_by_element(const Molecule& molecule,
                                     const std::vector<std::uint32_t>& atom_of_ball);
// Chains in the order in which the molecule has them; the colours repeat as chain_colour() does.
std::vector<Rgb8> colours_by_chain(const Molecule& molecule,
                                   const std::vector<std::uint32_t>& atom_of_ball);

}  // namespace alphascope
