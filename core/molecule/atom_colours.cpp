// SPDX-License-Identifier: GPL-3.0-or-later
// Colours of elements and chains.
// Colours follow the Corey-Pauling-Koltun tradition: carbon grey, nitrogen blue, oxygen red,
// sulphur yellow. They are softened so that they show on light and dark backgrounds.
#include "core/molecule/atom_colours.hpp"

#include <array>

#include "core/molecule/molecule.hpp"
#include "core/molecule/rgb8.hpp"

namespace alphascope {
namespace {

// These colours were found by annealing, together with those of cavities
// (core/chart/colour_map.cpp). Annealing maximised the least difference of two colours, with usual
// sight and with three kinds of colour blindness. The first colours got more weight, and neighbours
// differ in lightness. tests/core/chart/colour_difference_test.cpp has the bounds that were
// reached.
constexpr std::array<Rgb8, kChainColours> kColoursOfChains{
    {{86, 156, 214},  {255, 176, 177}, {93, 138, 96},   {112, 96, 145},  {138, 129, 27},
     {150, 190, 79},  {200, 198, 255}, {186, 119, 145}, {168, 229, 228}, {158, 26, 106},
     {42, 105, 220},  {6, 97, 71},     {23, 245, 203},  {4, 144, 132},   {68, 76, 165},
     {141, 185, 207}, {160, 127, 173}, {105, 118, 58},  {161, 39, 3},    {196, 162, 171},
     {148, 83, 105},  {148, 159, 133}, {218, 224, 129}, {63, 96, 47}}};

}  // namespace

Rgb8 element_colour(Element element) {
  switch (element) {
    case 1:
      return {228, 232, 236};  // H
    case 6:
      return {122, 130, 141};  // C: equally far from white and from the dark background
    case 7:
      return {84, 122, 226};  // N
    case 8:
      return {222, 78, 70};  // O
    case 9:
      return {130, 200, 120};  // F
    case 11:
      return {150, 110, 210};  // Na
    case 12:
      return {110, 180, 90};  // Mg
    case 15:
      return {236, 150, 60};  // P
    case 16:
      return {232, 204, 84};  // S
    case 17:
      return {96, 200, 100};  // Cl
    case 19:
      return {160, 90, 200};  // K
    case 20:
      return {120, 150, 130};  // Ca
    case 25:
      return {168, 130, 190};  // Mn
    case 26:
      return {212, 116, 60};  // Fe
    case 29:
      return {200, 136, 90};  // Cu
    case 30:
      return {138, 142, 178};  // Zn
    case 34:
      return {240, 170, 60};  // Se
    case 35:
      return {166, 80, 60};  // Br
    case 53:
      return {150, 70, 160};  // I
    case kUnknownElement:
      return kColoursOfChains[0];
    default:
      return {190, 130, 170};
  }
}

// The colours of Okabe and Ito.
std::optional<Rgb8> secondary_colour(SecondaryStructure kind) {
  if (is_helix(kind)) return Rgb8{213, 94, 0};
  if (kind == SecondaryStructure::strand || kind == SecondaryStructure::bridge) {
    return Rgb8{0, 114, 178};
  }
  return std::nullopt;
}

Rgb8 chain_colour(std::size_t n) {
  return kColoursOfChains[n % kChainColours];
}

std::vector<Rgb8> colours_by_element(const Molecule& molecule,
                                     const std::vector<std::uint32_t>& atom_of_ball) {
  std::vector<Rgb8> colours;
  colours.reserve(atom_of_ball.size());
  for (const std::uint32_t atom : atom_of_ball) {
    colours.push_back(element_colour(molecule.atoms[atom].element));
  }
  return colours;
}

}  // namespace alphascope
