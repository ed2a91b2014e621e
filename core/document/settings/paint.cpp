// SPDX-License-Identifier: GPL-3.0-or-later
// The table of colour schemes; reads and writes paints as text.
#include "core/document/settings/paint.hpp"

#include <algorithm>

#include "core/chart/colour_text.hpp"
#include "core/document/commands/number_input.hpp"
#include "core/geometry/shortest_number.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/text/choices.hpp"
#include "core/text/former_name.hpp"
#include "core/text_files/line_reader.hpp"

namespace alphascope {
namespace {

constexpr const char* kExample = "b_factor,cividis,0:60";

// Reads the range. Returns a sentence if it is invalid, otherwise an empty string.
std::string take_range(std::string_view text, const SchemeInfo& scheme, Paint& paint) {
  const std::size_t colon = text.find(':');
  const NumberRule rule = range_rule(scheme);
  const NumberInput low = read_number(std::string(text.substr(0, colon)), rule);
  const NumberInput high = read_number(std::string(text.substr(colon + 1)), rule);
  if (!low.value || !high.value) return low.value ? high.error : low.error;
  if (!(*low.value < *high.value)) {
    return "The range " + in_quotes(text) + " is empty. Write the smaller value first, as in 0:60.";
  }
  paint.range = ColourRange{*low.value, *high.value};
  return {};
}

}  // namespace

const std::vector<SchemeInfo>& all_schemes() {
  using enum ColourMap;
  static const std::vector<SchemeInfo> schemes{
      {.by = ColourBy::element,
       .id = "element",
       .title = "Element",
       .balls = true,
       .simplices = true},
      {.by = ColourBy::chain, .id = "chain", .title = "Chain", .balls = true, .simplices = true},
      {.by = ColourBy::residue_class,
       .id = "residue_class",
       .title = "Class of residue (Lesk)",
       .balls = true,
       .simplices = true,
       .former_id = "residue_kind"},
      {.by = ColourBy::residue_index,
       .id = "residue_index",
       .title = "Place along the chain",
       .balls = true,
       .simplices = false,
       .quantity = true,
       .unit = "%",
       .map = rainbow},
      {.by = ColourBy::b_factor,
       .id = "b_factor",
       .title = "B factor",
       .balls = true,
       .simplices = false,
       .quantity = true,
       .unit = "Å²",
       .map = blue_white_red},
      {.by = ColourBy::component,
       .id = "component",
       .title = "Component",
       .balls = true,
       .simplices = true,
       .of_complex = true},
      {.by = ColourBy::exposed,
       .id = "exposed",
       .title = "Exposed area of atoms",
       .balls = true,
       .simplices = false,
       .quantity = true,
       .unit = "%",
       .map = viridis,
       .root = true,
       .of_complex = true},
      {.by = ColourBy::exposed_residue,
       .id = "exposed_residue",
       .title = "Exposed area of residues",
       .balls = true,
       .simplices = false,
       .quantity = true,
       .unit = "%",
       .map = viridis,
       .root = true,
       .of_complex = true},
      {.by = ColourBy::alpha,
       .id = "alpha",
       .title = "Alpha value",
       .balls = false,
       .simplices = true,
       .quantity = true,
       .unit = "Å²",
       .map = viridis,
       .root = true,
       .of_complex = true},
      {.by = ColourBy::simplex_class,
       .id = "class",
       .title = "Class",
       .balls = false,
       .simplices = true,
       .of_complex = true},
      {.by = ColourBy::single,
       .id = "single",
       .title = "One colour",
       .balls = true,
       .simplices = true}};
  return schemes;
}

const SchemeInfo& scheme_info(ColourBy by) {
  const auto& all = all_schemes();
  return *std::find_if(all.begin(), all.end(), [by](const SchemeInfo& s) { return s.by == by; });
}

bool can_paint(const SchemeInfo& scheme, PaintTarget what) {
  return what == PaintTarget::balls ? scheme.balls : scheme.simplices;
}

NumberRule range_rule(const SchemeInfo& scheme) {
  if (scheme.by == ColourBy::alpha) {
    return {"An end of the range", kAlphaRule.least, kAlphaRule.most, scheme.unit};
  }
  if (std::string_view(scheme.unit) == "%") return {"An end of the range", 0, 100, scheme.unit};
  return {"An end of the range", -1e6, 1e6, scheme.unit};
}

Paint with_scheme(Paint paint, ColourBy by) {
  if (paint.by == by) return paint;
  paint.by = by;
  paint.range.reset();
  if (!scheme_info(by).quantity) paint.map.reset();
  if (by != ColourBy::single) paint.colour.reset();
  return paint;
}

std::string scheme_ids(PaintTarget what) {
  std::string ids;
  for (const SchemeInfo& scheme : all_schemes()) {
    if (can_paint(scheme, what)) ids += (ids.empty() ? "" : "|") + std::string(scheme.id);
  }
  return ids;
}

PaintWords read_paint(std::string_view text, PaintTarget what) {
  Paint paint;
  std::string note;
  const auto refused = [](const std::string& why) { return PaintWords{{}, why, {}}; };
  std::size_t end = std::min(text.find(','), text.size());
  const std::string_view name = trimmed(text.substr(0, end));
  const auto& all = all_schemes();
  const auto named = std::find_if(all.begin(), all.end(), [&](const SchemeInfo& s) {
    return !name.empty() && (s.id == name || s.former_id == name) && can_paint(s, what);
  });
  if (named != all.end()) {
    paint.by = named->by;
    if (named->id != name) note = in_quotes(name) + " " + is_called_now(named->id);
  } else if (name.starts_with('#') && read_colour(name)) {
    paint = {ColourBy::single, {}, {}, read_colour(name)};
  } else {
    return refused(in_quotes(name) + " is not a colour scheme of " +
                   (what == PaintTarget::balls ? "balls" : "simplices") + ". Write " +
                   in_words(scheme_ids(what)) + ", or a colour such as #5aa9e6.");
  }
  const SchemeInfo& scheme = scheme_info(paint.by);
  while (end < text.size()) {
    const std::size_t begin = end + 1;
    end = std::min(text.find(',', begin), text.size());
    const std::string_view word = trimmed(text.substr(begin, end - begin));
    if (!scheme.quantity) {
      return refused(in_quotes(word) + ": " + scheme.id +
                     " has neither map nor range. Leave it out.");
    }
    if (const auto map = colour_map_named(word)) {
      paint.map = map;
    } else if (word.find(':') == std::string_view::npos) {
      return refused(in_quotes(word) + " is neither a colour map (" + in_words(colour_map_ids()) +
                     ") nor a range such as 0:60. Write " + kExample + ".");
    } else if (const std::string fault = take_range(word, scheme, paint); !fault.empty()) {
      return refused(fault);
    }
  }
  return {paint, {}, note};
}

std::string paint_text(const Paint& paint) {
  if (paint.by == ColourBy::single && paint.colour) return colour_text(*paint.colour);
  std::string text = scheme_info(paint.by).id;
  if (paint.map) text += std::string(",") + colour_map_info(*paint.map).id;
  if (paint.range) {
    text += "," + shortest_number(paint.range->low) + ":" + shortest_number(paint.range->high);
  }
  return text;
}

}  // namespace alphascope
