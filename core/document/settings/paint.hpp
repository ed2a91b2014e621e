// What balls and simplices are coloured by: a scheme, a colour map and a range of values. How such
// a choice is written as text is here as well; the colours are made in paint_balls.hpp.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/chart/colour_scale.hpp"
#include "core/document/commands/number_input.hpp"

namespace alphascope {

enum class ColourBy : std::uint8_t {
  element,
  chain,
  single,           // one colour
  alpha,            // of simplices: their alpha values
  exposed,          // share of the area of an atom's whole sphere that is on the surface of all
  exposed_residue,  // of the spheres of its residue
  residue_kind,     // Lesk's classes of amino acids; nucleotides, ligands, ions, water
  residue_index,    // the place of its residue along the chain
  b_factor,
  component,      // of the complex
  simplex_class,  // of simplices: singular, regular or interior
};

inline bool is_exposure(ColourBy colour) {
  return colour == ColourBy::exposed || colour == ColourBy::exposed_residue;
}

enum class Painted : std::uint8_t { balls, simplices };

struct SchemeInfo {
  ColourBy by;
  const char* id;           // in sessions, commands and on the command line: "b_factor"
  const char* title;        // in lists: "B factor"
  bool balls, simplices;    // what can be coloured by it
  bool quantity = false;    // else categories, or one colour
  const char* unit = "";    // of a quantity
  ColourMap map = {};       // of a quantity, unless another is chosen
  bool root = false;        // its colours follow the square root
  bool of_complex = false;  // other colours with each complex
};
const SchemeInfo& scheme_info(ColourBy by);
const std::vector<SchemeInfo>& all_schemes();  // in the order of lists
bool can_paint(const SchemeInfo& scheme, Painted what);
NumberRule range_rule(const SchemeInfo& scheme);  // of both ends of the range of a quantity

struct Paint {
  ColourBy by = ColourBy::chain;
  std::optional<ColourMap> map = {};  // of a quantity; none: the scheme's
  std::optional<ColourRange> range =
      {};                           // in the scheme's unit; none: of the values that there are
  std::optional<Rgb8> colour = {};  // of ColourBy::single; none: the usual one

  ColourMap map_used() const { return map.value_or(scheme_info(by).map); }
  friend bool operator==(const Paint&, const Paint&) = default;
};

// By another scheme. A range is of its own scheme only; a map goes over from quantity to quantity.
Paint with_scheme(Paint paint, ColourBy by);

// "chain"; "b_factor,cividis,0:60", with map and range in any order or without them; "#ff8800".
struct PaintWords {
  Paint paint;
  std::string error;  // a sentence with the remedy; empty: the paint holds
};
PaintWords read_paint(std::string_view text, Painted what);
std::string paint_text(const Paint& paint);
std::string scheme_ids(Painted what);  // "element|chain|..."

}  // namespace alphascope
