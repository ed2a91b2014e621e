// SPDX-License-Identifier: GPL-3.0-or-later
// Atoms that the picture hides, and atoms with a colour of their own. Only the picture changes:
// nothing is computed anew.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/document/reference/atom_set.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/molecule/rgb8.hpp"

namespace alphascope {

struct Molecule;
struct PreparedBalls;

struct OwnColour {
  Rgb8 colour;
  AtomSet atoms;
  friend bool operator==(const OwnColour&, const OwnColour&) = default;
};

struct Appearance {
  AtomSet hidden;                  // hidden atoms; simplices with such a corner are hidden too
  std::vector<OwnColour> colours;  // an atom is in at most one; none is empty
  bool plain() const { return hidden.empty() && colours.empty(); }
  friend bool operator==(const Appearance&, const Appearance&) = default;
};

// Gives these atoms a colour; nullopt: they get the colour of their scheme again.
void set_colour(Appearance& appearance, const AtomSet& atoms, const std::optional<Rgb8>& colour);

// The appearance of the balls of one picture.
struct BallAppearance {
  std::vector<bool> hidden;  // one value a ball; empty: none is hidden
  std::size_t hidden_balls = 0;
  std::vector<std::pair<BallIndex, Rgb8>> colours;  // ascending

  bool hides(BallIndex ball) const { return !hidden.empty() && hidden[ball]; }
  // Whether one of the simplex' balls is hidden.
  template <class Simplex>
  bool hides_some(const Simplex& balls) const {
    if (hidden.empty()) return false;
    for (const BallIndex ball : balls) {
      if (hidden[ball]) return true;
    }
    return false;
  }
  void paint(std::vector<Rgb8>& colours_of_balls) const {
    for (const auto& [ball, colour] : colours) colours_of_balls.at(ball) = colour;
  }
};
// Words of a command line. `hide` and `only` are selection expressions (empty: nothing is hidden;
// all atoms are shown). `colours` is such as "resn HEM=#ff8800; chain A=#888". Throws
// SelectionError. Throws std::invalid_argument for a text that is not a colour, or an expression
// without any atom.
struct AppearanceWords {
  std::string hide, only, colours;
};
Appearance read_appearance(const Molecule& molecule, const AppearanceWords& words);

// A PreparedBalls that contains only the left-out atoms that are not hidden.
PreparedBalls left_out_and_shown(const Molecule& molecule, const PreparedBalls& prepared,
                                 const AtomSet& hidden);

// If `looks` is null, both return their argument unchanged.
std::vector<Rgb8> painted(std::vector<Rgb8> colours, const BallAppearance* looks);
std::vector<float> shown_radii(std::vector<float> radii, const BallAppearance* looks);  // hidden: 0

BallAppearance ball_appearance(const Molecule& molecule,
                               const std::vector<std::uint32_t>& atom_of_ball,
                               const Appearance& appearance);

}  // namespace alphascope
