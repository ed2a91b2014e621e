// SPDX-License-Identifier: GPL-3.0-or-later
// A paint, the colouring of balls and simplices: a scheme, a colour map and a range of values. This
// also reads and writes paints as text; paint_balls.hpp makes the colours.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/chart/colour_scale.hpp"
#include "core/molecule/rgb8.hpp"

namespace alphascope {

struct NumberRule;

enum class ColourBy : std::uint8_t {
  element,
  chain,
  single,           // one colour
  alpha,            // alpha values of simplices
  exposed,          // share of the whole sphere of an atom that is on the surface of all balls
  exposed_residue,  // the same for the spheres of its residue
  residue_class,    // Lesk's classes of amino acids; nucleotides, ligands, ions, water
  residue_index,    // position of its residue along the chain
  b_factor,
  component,      // of the complex
  simplex_class,  // class of a simplex: singular, regular or interior
};

inline bool is_exposure(ColourBy colour) {
  return colour == ColourBy::exposed || colour == ColourBy::exposed_residue;
}

enum class PaintTarget : std::uint8_t { balls, simplices };

struct SchemeInfo {
  ColourBy by;
  const char* id;              // in sessions, commands and on the command line: "b_factor"
  const char* title;           // in lists: "B factor"
  bool balls, simplices;       // whether it applies to balls, to simplices
  bool quantity = false;       // false: categories, or one colour
  const char* unit = "";       // of a quantity
  ColourMap map = {};          // default map of a quantity
  bool root = false;           // colours follow the square root
  bool of_complex = false;     // colours change with the complex
  const char* former_id = "";  // still read in this version; empty: none
};
const SchemeInfo& scheme_info(ColourBy by);
const std::vector<SchemeInfo>& all_schemes();  // in the order of lists
bool can_paint(const SchemeInfo& scheme, PaintTarget what);
NumberRule range_rule(const SchemeInfo& scheme);  // bounds for both ends of the range

struct Paint {
  ColourBy by = ColourBy::chain;
  std::optional<ColourMap> map = {};  // of a quantity; none: the map of the scheme
  std::optional<ColourRange> range =
      {};                           // in the scheme's unit; none: of the values that there are
  std::optional<Rgb8> colour = {};  // of ColourBy::single; none: the default

  ColourMap map_used() const { return map.value_or(scheme_info(by).map); }
  friend bool operator==(const Paint&, const Paint&) = default;
};

// The paint with another scheme. The range is dropped; the map stays if both schemes are
// quantities.
Paint with_scheme(Paint paint, ColourBy by);

// Reads "chain", "b_factor,cividis,0:60" (map and range in any order, or none) or "#ff8800".
struct PaintWords {
  Paint paint;
  std::string error;      // a sentence with the remedy; empty: the text is valid
  std::string note = {};  // on a former name; empty: none
};
PaintWords read_paint(std::string_view text, PaintTarget what);
std::string paint_text(const Paint& paint);
std::string scheme_ids(PaintTarget what);  // "element|chain|..."

}  // namespace alphascope
