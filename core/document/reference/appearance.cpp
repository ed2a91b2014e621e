// SPDX-License-Identifier: GPL-3.0-or-later
// Reads hidden atoms and colours, and applies them to balls.
#include "core/document/reference/appearance.hpp"

#include <algorithm>

#include "core/chart/colour_text.hpp"
#include "core/document/reference/atom_words.hpp"
#include "core/molecule/molecule.hpp"
#include "core/selection/prepare_balls.hpp"

namespace alphascope {

void set_colour(Appearance& appearance, const AtomSet& atoms, const std::optional<Rgb8>& colour) {
  set_value_of_atoms(appearance.colours, &OwnColour::colour, atoms, colour);
}

Appearance read_appearance(const Molecule& molecule, const AppearanceWords& words) {
  Appearance appearance;
  if (!words.only.empty()) {
    appearance.hidden = all_atoms(molecule).without(some_named(molecule, words.only));
  }
  if (!words.hide.empty()) {
    appearance.hidden = appearance.hidden.with(some_named(molecule, words.hide));
  }
  constexpr const char* kWhat = "their colour";
  constexpr const char* kExample = "resn HEM=#ff8800";
  for (const AtomWord& word : atom_words(molecule, words.colours, kWhat, kExample)) {
    const std::optional<Rgb8> colour = read_colour(word.word);
    if (!colour) refuse_atom_word(word.part, kWhat, kExample);
    set_colour(appearance, word.atoms, colour);
  }
  return appearance;
}

PreparedBalls left_out_and_shown(const Molecule& molecule, const PreparedBalls& prepared,
                                 const AtomSet& hidden) {
  PreparedBalls shown;
  shown.left_out = prepared.left_out;
  if (hidden.empty()) return shown;
  const std::vector<bool> atoms = atoms_of(molecule, hidden);
  std::erase_if(shown.left_out, [&](const LeftOutAtom& left) { return atoms[left.atom]; });
  return shown;
}

std::vector<Rgb8> painted(std::vector<Rgb8> colours, const BallAppearance* looks) {
  if (looks) looks->paint(colours);
  return colours;
}

std::vector<float> shown_radii(std::vector<float> radii, const BallAppearance* looks) {
  if (!looks || looks->hidden.empty()) return radii;
  for (std::size_t ball = 0; ball < radii.size(); ++ball) {
    if (looks->hidden[ball]) radii[ball] = 0;
  }
  return radii;
}

BallAppearance ball_appearance(const Molecule& molecule,
                               const std::vector<std::uint32_t>& atom_of_ball,
                               const Appearance& appearance) {
  BallAppearance of;
  if (!appearance.hidden.empty()) {
    const std::vector<bool> atoms = atoms_of(molecule, appearance.hidden);
    of.hidden.resize(atom_of_ball.size());
    for (std::size_t ball = 0; ball < atom_of_ball.size(); ++ball) {
      of.hidden[ball] = atoms[atom_of_ball[ball]];
      of.hidden_balls += of.hidden[ball];
    }
    if (of.hidden_balls == 0) of.hidden.clear();
  }
  for (const OwnColour& own : appearance.colours) {
    const std::vector<bool> atoms = atoms_of(molecule, own.atoms);
    for (std::size_t ball = 0; ball < atom_of_ball.size(); ++ball) {
      if (atoms[atom_of_ball[ball]]) {
        of.colours.emplace_back(static_cast<BallIndex>(ball), own.colour);
      }
    }
  }
  std::sort(of.colours.begin(), of.colours.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  return of;
}

}  // namespace alphascope
