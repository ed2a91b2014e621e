// The colours of elements follow the Corey-Pauling-Koltun tradition (carbon grey, nitrogen blue,
// oxygen red, sulphur yellow), softened so that light and dark backgrounds both carry them.
#include "core/molecule/atom_colours.hpp"

#include <array>

namespace alphascope {
namespace {

constexpr std::array<Rgb8, 10> kChainColours{{{86, 156, 214},
                                              {226, 145, 76},
                                              {104, 186, 120},
                                              {206, 105, 140},
                                              {160, 130, 205},
                                              {216, 190, 88},
                                              {84, 186, 186},
                                              {222, 120, 105},
                                              {140, 160, 180},
                                              {150, 180, 90}}};

}  // namespace

Rgb8 element_colour(Element element) {
  switch (element) {
    case 1:
      return {228, 232, 236};  // H
    case 6:
      return {122, 130, 141};  // C: as far from white as from the dark background
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
      return kChainColours[0];
    default:
      return {190, 130, 170};
  }
}

Rgb8 chain_colour(std::size_t n) {
  return kChainColours[n % kChainColours.size()];
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

std::vector<Rgb8> colours_by_chain(const Molecule& molecule,
                                   const std::vector<std::uint32_t>& atom_of_ball) {
  // Over all atoms, so that a chain keeps its colour when another one is switched off.
  std::vector<Rgb8> of_chain(molecule.names.size());
  std::vector<bool> seen(molecule.names.size(), false);
  std::size_t chains = 0;
  for (const Atom& atom : molecule.atoms) {
    if (seen[atom.chain]) continue;
    seen[atom.chain] = true;
    of_chain[atom.chain] = chain_colour(chains++);
  }
  std::vector<Rgb8> colours;
  colours.reserve(atom_of_ball.size());
  for (const std::uint32_t atom : atom_of_ball) {
    colours.push_back(of_chain[molecule.atoms[atom].chain]);
  }
  return colours;
}

}  // namespace alphascope
