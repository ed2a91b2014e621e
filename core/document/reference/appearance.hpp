// Which atoms the picture leaves out, and which have a colour of their own. Of the picture only:
// nothing is computed anew, and no number changes.
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
  AtomSet hidden;                  // not drawn, nor is a simplex with a corner among them
  std::vector<OwnColour> colours;  // no atom is in two of them, and none is empty
  bool plain() const { return hidden.empty() && colours.empty(); }
  friend bool operator==(const Appearance&, const Appearance&) = default;
};

// Of these atoms; nullopt: the colour that all others have.
void set_colour(Appearance& appearance, const AtomSet& atoms, const std::optional<Rgb8>& colour);

// What it means to the balls of one picture.
struct BallAppearance {
  std::vector<bool> hidden;  // one a ball; empty: none is
  std::size_t hidden_balls = 0;
  std::vector<std::pair<BallIndex, Rgb8>> colours;  // ascending

  bool hides(BallIndex ball) const { return !hidden.empty() && hidden[ball]; }
  // One of the simplex' balls is hidden.
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
// The words of a command line, as `hide` and `only` (selection expressions; empty: none is hidden,
// all are shown) and `colours`: "resn HEM=#ff8800; chain A=#888". Throws SelectionError, and
// std::invalid_argument for a colour that is none and for an expression without any atom.
struct AppearanceWords {
  std::string hide, only, colours;
};
Appearance read_appearance(const Molecule& molecule, const AppearanceWords& words);

// The prepared molecule with nothing but the atoms that are no balls and not hidden.
PreparedBalls left_out_and_shown(const Molecule& molecule, const PreparedBalls& prepared,
                                 const AtomSet& hidden);

// Null looks change nothing.
std::vector<Rgb8> painted(std::vector<Rgb8> colours, const BallAppearance* looks);
std::vector<float> shown_radii(std::vector<float> radii, const BallAppearance* looks);  // hidden: 0

BallAppearance ball_appearance(const Molecule& molecule,
                               const std::vector<std::uint32_t>& atom_of_ball,
                               const Appearance& appearance);

}  // namespace alphascope
