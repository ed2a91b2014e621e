// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds and colours of objects, and objects as text.
#include "core/document/settings/drawn_object.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "core/chart/colour_text.hpp"
#include "core/selection/contents.hpp"
#include "core/selection/selection_expression.hpp"
#include "core/text/choices.hpp"
#include "core/text/text_parts.hpp"
#include "core/text_files/line_reader.hpp"

namespace alphascope {
namespace {

constexpr std::array kKinds{
    ObjectKindInfo{ObjectKind::cartoon, "cartoon", "Cartoon",
                   "ribbons of proteins, ladders of nucleic acids", ObjectColour::chain},
    ObjectKindInfo{ObjectKind::sticks, "sticks", "Sticks", "bonds", ObjectColour::element},
    ObjectKindInfo{ObjectKind::balls_and_sticks, "balls_and_sticks", "Balls and sticks",
                   "atoms and bonds", ObjectColour::element},
    ObjectKindInfo{ObjectKind::points, "points", "Points", "atoms, a few pixels each",
                   ObjectColour::element}};
constexpr std::array kColours{
    ObjectColourInfo{ObjectColour::element, "element", "Element"},
    ObjectColourInfo{ObjectColour::chain, "chain", "Chain"},
    ObjectColourInfo{ObjectColour::secondary, "secondary", "Helices and strands"},
    ObjectColourInfo{ObjectColour::single, "single", "One colour"}};
constexpr const char *kHidden = "hidden", *kNone = "none";
constexpr const char* kExample = "\"cartoon,secondary,40%:chain A\"";

constexpr double kLeastPercent = 100 * kLeastOpacity;

// The share of "40%"; empty if it is none of kLeastPercent to 100 percent.
std::optional<float> read_share(std::string_view word) {
  if (!word.ends_with('%')) return std::nullopt;
  word.remove_suffix(1);
  double percent = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), percent);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  if (!(percent >= kLeastPercent && percent <= 100)) return std::nullopt;
  return static_cast<float>(percent / 100);
}

// Takes a word between the kind and the atoms. Returns a fault, or nothing.
std::string take_word(std::string_view word, DrawnObject& object) {
  const auto colour = std::find_if(kColours.begin(), kColours.end(),
                                   [&](const ObjectColourInfo& c) { return c.id == word; });
  if (colour != kColours.end()) {
    object.colour = colour->colour;
  } else if (const auto share = read_share(word)) {
    object.opacity = *share;
  } else if (word.starts_with('#') && read_colour(word)) {
    object.colour = ObjectColour::single;
    object.own = *read_colour(word);
  } else if (word == kHidden) {
    object.shown = false;
  } else {
    return in_quotes(word) + " is neither a colour (" + in_words(object_colour_ids()) +
           ", or one such as #5aa9e6) nor an opacity from " +
           std::to_string(std::lround(kLeastPercent)) + "% to 100%. Write for instance " +
           kExample + ".";
  }
  return {};
}

}  // namespace

std::span<const ObjectKindInfo> object_kinds() {
  return kKinds;
}

const ObjectKindInfo& object_kind_info(ObjectKind kind) {
  return kKinds.at(static_cast<std::size_t>(kind));
}

std::span<const ObjectColourInfo> object_colours() {
  return kColours;
}

const ObjectColourInfo& object_colour_info(ObjectColour colour) {
  return kColours.at(static_cast<std::size_t>(colour));
}

std::string object_kind_ids() {
  std::string ids;
  for (const ObjectKindInfo& kind : kKinds) ids += (ids.empty() ? "" : "|") + std::string(kind.id);
  return ids;
}

std::string object_colour_ids() {
  std::string ids;
  for (const ObjectColourInfo& c : kColours) ids += (ids.empty() ? "" : "|") + std::string(c.id);
  return ids;
}

ObjectWords read_object(std::string_view text) {
  const auto refused = [](const std::string& why) { return ObjectWords{{}, why}; };
  const std::size_t colon = std::min(text.find(':'), text.size());
  std::string_view words = text.substr(0, colon);
  DrawnObject object;
  object.atoms = trimmed(text.substr(std::min(colon + 1, text.size())));
  std::size_t end = std::min(words.find(','), words.size());
  const std::string_view name = trimmed(words.substr(0, end));
  const auto kind = std::find_if(kKinds.begin(), kKinds.end(),
                                 [&](const ObjectKindInfo& k) { return k.id == name; });
  if (kind == kKinds.end()) {
    return refused(in_quotes(name) + " is no object. Write " + in_words(object_kind_ids()) +
                   "; for instance " + kExample + ".");
  }
  object.kind = kind->kind;
  object.colour = kind->colour;
  while (end < words.size()) {
    const std::size_t begin = end + 1;
    end = std::min(words.find(',', begin), words.size());
    const std::string fault = take_word(trimmed(words.substr(begin, end - begin)), object);
    if (!fault.empty()) return refused(fault);
  }
  if (const auto fault = fault_of_selection(object.atoms)) return refused(fault->what());
  return {object, {}};
}

std::string object_text(const DrawnObject& object) {
  const ObjectKindInfo& kind = object_kind_info(object.kind);
  std::string text = kind.id;
  if (object.colour == ObjectColour::single) {
    text += "," + colour_text(object.own);
  } else if (object.colour != kind.colour) {
    text += std::string(",") + object_colour_info(object.colour).id;
  }
  if (object.opacity < 1) {
    text += "," + std::to_string(std::lround(100 * object.opacity)) + "%";
  }
  if (!object.shown) text += std::string(",") + kHidden;
  if (!object.atoms.empty()) text += ":" + object.atoms;
  return text;
}

ObjectListWords read_objects(std::string_view text) {
  if (trimmed(text).empty() || trimmed(text) == kNone) return {};
  ObjectListWords list;
  for (const std::string& part : parts_of(text, ';')) {
    ObjectWords words = read_object(part);
    if (!words.error.empty()) return {{}, words.error};
    list.objects.push_back(std::move(words.object));
  }
  if (list.objects.size() > kMostObjects) {
    return {{},
            "There are " + std::to_string(list.objects.size()) + " objects; at most " +
                std::to_string(kMostObjects) + " are drawn."};
  }
  return list;
}

std::string objects_text(const DrawnObjects& objects) {
  std::string text;
  for (const DrawnObject& object : objects) {
    text += (text.empty() ? "" : "; ") + object_text(object);
  }
  return text.empty() ? kNone : text;
}

DrawnObjects usual_objects(const MoleculeContents& contents) {
  if (of_kind(contents.kinds_with_names, ResidueKind::polymer) == 0) return {};
  // It is opaque: a translucent one takes five times as long to draw without a GPU.
  DrawnObjects objects{{.kind = ObjectKind::cartoon}};
  if (of_kind(contents.kinds_with_names, ResidueKind::ligand) > 0) {
    objects.push_back(
        {.kind = ObjectKind::sticks, .atoms = "ligand", .colour = ObjectColour::element});
  }
  return objects;
}

std::string object_title(const DrawnObject& object) {
  const std::string title = object_kind_info(object.kind).title;
  return object.atoms.empty() ? title : title + " of " + object.atoms;
}

}  // namespace alphascope
