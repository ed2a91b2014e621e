// SPDX-License-Identifier: GPL-3.0-or-later
// Objects are drawn of the molecule's atoms, beside balls and simplices: cartoons, sticks, points.
// No result depends on them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/molecule/rgb8.hpp"

namespace alphascope {

struct MoleculeContents;

inline constexpr double kLeastOpacity = 0.05;  // of all that is drawn; less is hardly visible

enum class ObjectKind : std::uint8_t {
  cartoon,           // ribbons of proteins, ladders of nucleic acids
  sticks,            // bonds
  balls_and_sticks,  // atoms and bonds
  points             // atoms, a few pixels each
};

enum class ObjectColour : std::uint8_t {
  element,
  chain,      // atoms outside polymers have the colours of their elements
  secondary,  // helices, strands, the rest; atoms outside polymers as above
  single      // DrawnObject::own
};

struct DrawnObject {
  ObjectKind kind = ObjectKind::cartoon;
  std::string atoms;  // a selection expression; empty: all atoms of the model
  ObjectColour colour = ObjectColour::chain;
  Rgb8 own{200, 200, 200};  // of ObjectColour::single
  bool shown = true;
  float opacity = 1;  // kLeastOpacity to 1
  friend bool operator==(const DrawnObject&, const DrawnObject&) = default;
};
using DrawnObjects = std::vector<DrawnObject>;
inline constexpr std::size_t kMostObjects = 32;

struct ObjectKindInfo {
  ObjectKind kind;
  const char* id;       // in sessions, commands and on the command line: "balls_and_sticks"
  const char* title;    // in lists: "Ball and stick"
  const char* help;     // a noun phrase
  ObjectColour colour;  // of a new object
};
std::span<const ObjectKindInfo> object_kinds();
const ObjectKindInfo& object_kind_info(ObjectKind kind);

struct ObjectColourInfo {
  ObjectColour colour;
  const char* id;
  const char* title;
};
std::span<const ObjectColourInfo> object_colours();
const ObjectColourInfo& object_colour_info(ObjectColour colour);

// Reads "cartoon", "sticks:ligand" or "cartoon,secondary,40%:chain A,B": kind, then colour and
// opacity in any order or not at all, then the atoms. "hidden" makes an object that is not shown.
struct ObjectWords {
  DrawnObject object;
  std::string error;  // a sentence with the remedy; empty: the text is valid
};
ObjectWords read_object(std::string_view text);
std::string object_text(const DrawnObject& object);
// Several, with semicolons between them: "cartoon; sticks:ligand". "none" and a blank text are no
// objects.
struct ObjectListWords {
  DrawnObjects objects;
  std::string error;  // as in ObjectWords
};
ObjectListWords read_objects(std::string_view text);
std::string objects_text(const DrawnObjects& objects);
// The objects of a molecule that is opened: a cartoon and the ligands of a protein or nucleic acid.
DrawnObjects usual_objects(const MoleculeContents& contents);
// "Cartoon", "Sticks of ligand".
std::string object_title(const DrawnObject& object);
std::string object_kind_ids();    // "cartoon|sticks|…"
std::string object_colour_ids();  // "element|chain|…"

}  // namespace alphascope
