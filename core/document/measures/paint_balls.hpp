// The colours that a paint gives to balls, and what they mean. One place for the window, the
// command line and saved pictures.
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

namespace alphascope {

struct PaintCategory {
  std::string name;
  Rgb8 colour;
  friend bool operator==(const PaintCategory&, const PaintCategory&) = default;
};

// What colours mean: those of a quantity along a scale, or those of categories.
struct PaintKey {
  std::string title;                      // "B factor (Å²)"
  std::optional<ColourScale> scale;       // in the unit of the title
  std::vector<PaintCategory> categories;  // of which there are balls; or without a value
  friend bool operator==(const PaintKey&, const PaintKey&) = default;
};

struct PaintedMolecule {
  const Molecule& molecule;
  const std::vector<std::uint32_t>& atom_of_ball;  // as in PreparedBalls
  // What only some schemes need; null where there is none.
  const AlphaComplex* complex = nullptr;
  const UnionMeasures* measures = nullptr;  // of `grown`, for exposed areas
  const BallSet* grown = nullptr;           // with the solvent radius
};

// A number or a category for each ball.
struct BallValues {
  std::vector<float> numbers;              // of a quantity, in its unit; NaN: none
  std::vector<std::uint32_t> category_of;  // else: index into `categories`
  std::vector<PaintCategory> categories;
  std::string no_number;  // what NaN means: "no B factor in the file"
  std::string lacks;      // a sentence: why there are no values; empty: there are
};
// Not of ColourBy::single.
BallValues ball_values(const PaintedMolecule& of, ColourBy by);

struct PaintedBalls {
  std::vector<Rgb8> colours;    // one a ball
  std::optional<PaintKey> key;  // none: they mean nothing
  std::string lacks;            // as in BallValues
};
PaintedBalls paint_balls(const PaintedMolecule& of, const Paint& paint);

// "B factor (Å²)", "exposed area of atoms (%), square-root scale".
std::string quantity_title(const SchemeInfo& scheme);

// Of simplices by their classes.
Rgb8 class_colour(SimplexClass of);
PaintKey class_key();

inline constexpr Rgb8 kNoValueColour{128, 128, 128};

}  // namespace alphascope
