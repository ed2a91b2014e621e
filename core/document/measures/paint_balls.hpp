// SPDX-License-Identifier: GPL-3.0-or-later
// Colours of balls for a paint, and their meaning, for the window, the command line and saved
// pictures.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/complex/alpha_complex.hpp"
#include "core/document/settings/paint.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/measure/union_measures.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/rgb8.hpp"

namespace alphascope {

struct PaintCategory {
  std::string name;
  Rgb8 colour;
  friend bool operator==(const PaintCategory&, const PaintCategory&) = default;
};

// Meaning of colours: a quantity along a scale, or categories.
struct ColourMeaning {
  std::string title;                      // "B factor (Å²)"
  std::optional<ColourScale> scale;       // in the unit of the title
  std::vector<PaintCategory> categories;  // those that some ball has; or one for balls without a
                                          // value
  friend bool operator==(const ColourMeaning&, const ColourMeaning&) = default;
};

struct PaintedMolecule {
  const Molecule& molecule;
  const std::vector<std::uint32_t>& atom_of_ball;  // as in PreparedBalls
  // Needed by some schemes only; null: not available.
  const AlphaComplex* complex = nullptr;
  const UnionMeasures* measures = nullptr;  // of `grown`, for exposed areas
  const BallSet* grown = nullptr;           // with the solvent radius
};

// A number or a category for each ball.
struct BallValues {
  std::vector<float> numbers;              // in the unit of the quantity; NaN: no value
  std::vector<std::uint32_t> category_of;  // if there are no numbers: index into `categories`
  std::vector<PaintCategory> categories;
  std::string no_number;  // meaning of NaN: "no B factor in the file"
  std::string lacks;      // sentence with the reason why there are no values; empty: there are
};
// Values of all schemes for balls except ColourBy::single.
BallValues ball_values(const PaintedMolecule& of, ColourBy by);

struct PaintedBalls {
  std::vector<Rgb8> colours;         // one a ball
  std::optional<ColourMeaning> key;  // none: the colours have no meaning
  std::string lacks;                 // as in BallValues
};
PaintedBalls paint_balls(const PaintedMolecule& of, const Paint& paint);

// "B factor (Å²)", "exposed area of atoms (%), square-root scale".
std::string quantity_title(const SchemeInfo& scheme);

// Colours of simplices by their classes.
Rgb8 class_colour(SimplexClass of);
ColourMeaning class_colour_meaning();

inline constexpr Rgb8 kNoValueColour{128, 128, 128};

}  // namespace alphascope
