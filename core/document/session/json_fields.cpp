// SPDX-License-Identifier: GPL-3.0-or-later
// Reads settings from JSON: FieldReader.
#include "core/document/session/json_fields.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "core/files/read_error.hpp"
#include "core/geometry/shortest_number.hpp"
#include "core/molecule/molecule.hpp"
#include "core/text/former_name.hpp"

namespace alphascope {
namespace {

// Limits that no session file of this program exceeds. The limit of a selection is
// Selection::kMostItems.
constexpr std::size_t kLongestText = std::size_t{1} << 20;  // bytes
constexpr std::size_t kMostRuns = 10000000;
constexpr std::size_t kShownOfAValue = 40;  // characters
constexpr NumberRule kAtomRule{"An atom", 0, 4294967295.0, "", true};
constexpr NumberRule kModelRule{"A model", 1, 1e6, "", true};

bool from_hexadecimal(const std::string& text, std::string& bytes) {
  bytes.clear();
  if (text.size() % 2 != 0) return false;
  for (std::size_t i = 0; i < text.size(); i += 2) {
    unsigned value = 0;
    const char* const end = text.data() + i + 2;
    if (std::from_chars(text.data() + i, end, value, 16).ptr != end) return false;
    bytes += static_cast<char>(value);
  }
  return true;
}

// A value as quoted in messages.
std::string shown(const ReadJson& json) {
  if (json.is_object()) return "an object";
  if (json.is_array()) return "a list";
  std::string text = json.dump(-1, ' ', true, ReadJson::error_handler_t::replace);
  if (text.size() > kShownOfAValue) text = text.substr(0, kShownOfAValue) + "…";
  return text;
}

std::string range_text(const NumberRule& rule) {
  const std::string unit = rule.unit[0] == '\0' ? "" : std::string(" ") + rule.unit;
  return std::string(rule.whole ? "a whole number" : "a number") + " from " +
         shortest_number(rule.least) + " to " + shortest_number(rule.most) + unit;
}

}  // namespace

JsonPlace FieldReader::below(const std::string& name) const {
  JsonPlace place = place_;
  place.push_back(name_in_file(name.c_str()));
  return place;
}

const char* FieldReader::name_in_file(const char* name) const {
  const auto former = former_.find(name);
  return former == former_.end() ? name : former->second;
}

void FieldReader::formerly(const char* old, const char* now) {
  if (!from_.contains(old) || from_.contains(now)) return;
  former_[now] = old;
  findings_.renamed.push_back({below(now), " " + is_called_now(now)});
}

const ReadJson* FieldReader::take(const char* name) {
  name = name_in_file(name);
  taken_.insert(name);
  const auto found = from_.find(name);
  return found == from_.end() ? nullptr : &*found;
}

void FieldReader::wrong(JsonPlace place, const ReadJson& value, const std::string& must_be) {
  findings_.wrong.push_back({std::move(place), "is " + shown(value) + ", and must be " + must_be});
}

void FieldReader::fault(JsonPlace place, std::string reason) {
  findings_.wrong.push_back({std::move(place), std::move(reason)});
}

void FieldReader::finish() {
  for (const auto& [name, value] : from_.items()) {
    if (!taken_.contains(name)) findings_.unknown.push_back(below(name));
  }
}

const ReadJson* FieldReader::take_object(const char* name) {
  const ReadJson* const json = take(name);
  if (json == nullptr || json->is_object()) return json;
  wrong(below(name), *json, "an object, in braces");
  return nullptr;
}

const ReadJson* FieldReader::take_list(const char* name, std::size_t most) {
  const ReadJson* const json = take(name);
  if (json == nullptr) return nullptr;
  if (json->is_array() && json->size() <= most) return json;
  wrong(below(name), *json, "a list, in square brackets, of at most " + std::to_string(most));
  return nullptr;
}

bool FieldReader::number(const JsonPlace& place, const ReadJson& json, double& value,
                         const NumberRule& rule) {
  const double read = json.is_number() ? json.get<double>() : std::nan("");
  const bool good = read >= rule.least && read <= rule.most &&
                    (!rule.whole || read == std::round(read));  // false for NaN
  if (good) {
    value = read == 0 ? 0 : read;  // not minus zero
  } else {
    wrong(place, json, range_text(rule));
  }
  return good;
}

bool FieldReader::atom(const JsonPlace& place, const ReadJson& json, AtomRef& value) {
  const bool pair = json.is_array() && json.size() == 2;
  double atom = 0, copy = 0;
  const bool good = number(place, pair ? json[0] : json, atom, kAtomRule) &&
                    (!pair || number(place, json[1], copy, kAtomRule));
  if (good) value = {static_cast<std::uint32_t>(atom), static_cast<std::uint32_t>(copy)};
  return good;
}

// Text must not contain NUL, which would end file names.
bool FieldReader::text(const JsonPlace& place, const ReadJson& json, std::string& value) {
  std::string read;
  bool good = json.is_string();
  if (good) {
    read = json.get_ref<const std::string&>();
  } else if (json.is_object() && json.size() == 1 && json.contains("bytes")) {
    const ReadJson& bytes = json["bytes"];
    good = bytes.is_string() && from_hexadecimal(bytes.get_ref<const std::string&>(), read);
  }
  good = good && read.size() <= kLongestText && read.find('\0') == std::string::npos;
  if (good) {
    value = std::move(read);
  } else {
    wrong(place, json, "text, in quotes");
  }
  return good;
}

std::size_t FieldReader::choose(const char* name, const std::vector<std::string_view>& words) {
  const ReadJson* const json = take(name);
  if (json == nullptr) return words.size();
  std::string known;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (json->is_string() && json->get_ref<const std::string&>() == words[i]) return i;
    known += (i == 0                  ? ""
              : i + 1 == words.size() ? " or "
                                      : ", ") +
             ("\"" + std::string(words[i])) + "\"";
  }
  wrong(below(name), *json, known);
  return words.size();
}

void FieldReader::operator()(const char* name, bool& value) {
  const ReadJson* const json = take(name);
  if (json == nullptr) return;
  if (json->is_boolean()) {
    value = json->get<bool>();
  } else {
    wrong(below(name), *json, "true or false");
  }
}

void FieldReader::operator()(const char* name, Alpha& value, const NumberRule& rule) {
  const ReadJson* const json = take(name);
  if (json == nullptr) return;
  if (!json->is_string()) {
    double read = 0;
    if (number(below(name), *json, read, rule)) value = read;
    return;
  }
  const AlphaInput input = read_alpha(json->get_ref<const std::string&>());
  if (input.value) {
    value = *input.value;
  } else {
    wrong(below(name), *json,
          range_text(rule) + ", with at most " + std::to_string(Alpha::kMostDigits) +
              " digits behind the point");
  }
}

void FieldReader::operator()(const char* name, double& value, const NumberRule& rule) {
  if (const ReadJson* json = take(name)) number(below(name), *json, value, rule);
}

void FieldReader::operator()(const char* name, float& value, const NumberRule& rule) {
  double read = value;
  const ReadJson* const json = take(name);
  if (json && number(below(name), *json, read, rule)) value = static_cast<float>(read);
}

void FieldReader::operator()(const char* name, int& value, const NumberRule& rule) {
  double read = value;
  const ReadJson* const json = take(name);
  if (json && number(below(name), *json, read, rule)) value = static_cast<int>(read);
}

void FieldReader::operator()(const char* name, std::array<double, 3>& value,
                             const NumberRule& rule) {
  const ReadJson* const json = take_list(name, 3);
  if (json == nullptr) return;
  if (json->size() != 3) return wrong(below(name), *json, "a list of three numbers");
  std::array<double, 3> read{};
  bool good = true;
  for (std::size_t k = 0; k < 3; ++k) {
    JsonPlace place = below(name);
    place.push_back(std::to_string(k));
    good = number(place, (*json)[k], read[k], rule) && good;
  }
  if (good) value = read;
}

void FieldReader::operator()(const char* name, std::string& value) {
  if (const ReadJson* json = take(name)) text(below(name), *json, value);
}

void FieldReader::operator()(const char* name, std::vector<std::string>& value) {
  const ReadJson* const json = take_list(name, kMostListed);
  if (json == nullptr) return;
  std::vector<std::string> read;
  for (std::size_t i = 0; i < json->size(); ++i) {
    JsonPlace place = below(name);
    place.push_back(std::to_string(i));
    read.emplace_back();
    if (!text(place, (*json)[i], read.back())) return;
  }
  value = std::move(read);
}

void FieldReader::operator()(const char* name, std::filesystem::path& value) {
  std::string read;
  const ReadJson* const json = take(name);
  if (json && text(below(name), *json, read)) value = read;
}

void FieldReader::operator()(const char* name, std::vector<std::filesystem::path>& value) {
  std::vector<std::string> read(value.begin(), value.end());
  (*this)(name, read);
  value.assign(read.begin(), read.end());
}

void FieldReader::operator()(const char* name, std::vector<RadiusOverride>& value) {
  const ReadJson* const json = take_list(name, kMostListed);
  if (json == nullptr) return;
  const std::size_t faults = findings_.wrong.size();
  std::vector<RadiusOverride> read;
  for (std::size_t i = 0; i < json->size(); ++i) {
    JsonPlace place = below(name);
    place.push_back(std::to_string(i));
    if (!(*json)[i].is_object()) return wrong(place, (*json)[i], "an object, in braces");
    FieldReader item((*json)[i], place, findings_);
    RadiusOverride edit;
    std::string symbol = "X";
    double radius = -1;
    item("residue", edit.atoms.residue);
    item("atom", edit.atoms.atom);
    item("element", symbol);
    item("radius_angstrom", radius, kBallRadiusRule);
    item.finish();
    edit.atoms.element = element_from_symbol(symbol);
    if (edit.atoms.element == kUnknownElement && symbol != "X") {
      wrong(item.below("element"), symbol, "the symbol of an element, or \"X\"");
    }
    if (radius < 0 && findings_.wrong.size() == faults) {
      wrong(place, (*json)[i], "an object with a \"radius_angstrom\"");
    }
    edit.microangstrom = static_cast<std::int32_t>(std::lround(radius * 1e6));
    read.push_back(std::move(edit));
  }
  if (findings_.wrong.size() == faults) value = std::move(read);
}

void FieldReader::operator()(const char* name, Clip& value) {
  const ReadJson* const json = take(name);
  if (json == nullptr) return;
  std::string written;
  if (!text(below(name), *json, written)) return;
  const ClipWords words = read_clip(written);
  if (!words.error.empty() || words.along_view || (words.clip.on() && !words.has_position)) {
    return wrong(below(name), *json,
                 "a cut such as \"x=12.5\", \"1,1,0=-3:8\" (a slab of 8 Å) or \"off\"");
  }
  value = words.clip;
}

void FieldReader::operator()(const char* name, Paint& value, PaintTarget what) {
  const ReadJson* const json = take(name);
  std::string written;
  if (json == nullptr || !text(below(name), *json, written)) return;
  const PaintWords words = read_paint(written, what);
  if (!words.error.empty()) {
    wrong(below(name), *json, "such as \"chain\" or \"b_factor,cividis,0:60\". " + words.error);
    return;
  }
  if (!words.note.empty()) findings_.renamed.push_back({below(name), ": " + words.note});
  value = words.paint;
}

void FieldReader::operator()(const char* name, RefSet& value) {
  const ReadJson* const json = take_list(name, Selection::kMostItems);
  if (json == nullptr) return;
  constexpr const char* kItem =
      "a list of one to four atoms, each a number from 0 or [number, copy]";
  std::vector<Ref> read;
  for (std::size_t i = 0; i < json->size(); ++i) {
    const ReadJson& item = (*json)[i];
    JsonPlace place = below(name);
    place.push_back(std::to_string(i));
    if (!item.is_array() || item.empty() || item.size() > 4) return wrong(place, item, kItem);
    SimplexRef corners;
    for (const ReadJson& corner : item) {
      corners.emplace_back();
      if (!atom(place, corner, corners.back())) return;
    }
    std::sort(corners.begin(), corners.end());
    if (std::adjacent_find(corners.begin(), corners.end()) != corners.end()) {
      return wrong(place, item, "a list of atoms that are all different");
    }
    read.push_back(corners.size() == 1 ? Ref(corners.front()) : Ref(std::move(corners)));
  }
  value = RefSet(std::move(read));
}

void FieldReader::operator()(const char* name, std::vector<AtomRef>& value) {
  const ReadJson* const json = take(name);
  if (json == nullptr || !json->is_array() || json->size() < 2 || json->size() > 4) {
    return wrong(below(name), json == nullptr ? ReadJson() : *json,
                 "a list of two to four atoms, each a number from 0 or [number, copy]");
  }
  std::vector<AtomRef> read(json->size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    JsonPlace place = below(name);
    place.push_back(std::to_string(i));
    if (!atom(place, (*json)[i], read[i])) return;
  }
  value = std::move(read);
}

void FieldReader::operator()(const char* name, AtomSet& value) {
  const ReadJson* const json = take_list(name, kMostRuns);
  if (json == nullptr) return;
  std::vector<AtomSet::Run> runs;
  for (std::size_t i = 0; i < json->size(); ++i) {
    const ReadJson& item = (*json)[i];
    JsonPlace place = below(name);
    place.push_back(std::to_string(i));
    double first = 0, last = 0, copy = 0;
    const bool shaped = item.is_array() && (item.size() == 2 || item.size() == 3);
    if (!shaped)
      return wrong(place, item, "[first, last] or [first, last, copy], numbers of atoms");
    const bool good = number(place, item[0], first, kAtomRule) &&
                      number(place, item[1], last, kAtomRule) &&
                      (item.size() == 2 || number(place, item[2], copy, kAtomRule));
    if (!good) return;
    if (last < first) return wrong(place, item, "a run whose last atom is not before its first");
    runs.push_back({static_cast<std::uint32_t>(copy), static_cast<std::uint32_t>(first),
                    static_cast<std::uint32_t>(last)});
  }
  value = AtomSet(std::move(runs));
}

void FieldReader::operator()(const char* name, Rgb8& value) {
  const ReadJson* const json = take(name);
  std::string written;
  if (json == nullptr || !text(below(name), *json, written)) return;
  const std::optional<Rgb8> colour = read_colour(written);
  if (!colour) return wrong(below(name), *json, "a colour such as \"#5aa9e6\"");
  value = *colour;
}

void FieldReader::operator()(const char* name, PictureBackground& value) {
  const ReadJson* const json = take(name);
  if (json == nullptr) return;
  if (json->is_boolean()) {  // the value of the former "transparent"
    value = {json->get<bool>(), {}};
    return;
  }
  std::string written;
  if (!text(below(name), *json, written)) return;
  const std::optional<PictureBackground> background = read_background(written);
  if (!background) return wrong(below(name), *json, kBackgroundWords);
  value = *background;
}

void FieldReader::operator()(const char* name, FileReference& value) {
  const ReadJson* const json = take_object(name);
  if (json == nullptr) return;
  FieldReader inner(*json, below(name), findings_);
  FileReference read;
  inner("path", read.relative);
  inner("absolute_path", read.absolute);
  inner("sha256", read.sha256);
  inner.finish();
  if (read.relative.is_absolute()) {
    if (!read.absolute.empty()) {
      wrong(inner.below("path"), read.relative.string(), "a path from the folder of this file");
    }
    read.absolute = std::exchange(read.relative, {});
  }
  if (!read.absolute.empty() && !read.absolute.is_absolute()) {
    wrong(inner.below("absolute_path"), read.absolute.string(), "a path that begins with /");
  }
  const bool hash = read.sha256.size() == 64 &&
                    read.sha256.find_first_not_of("0123456789abcdef") == std::string::npos;
  if (!hash) wrong(inner.below("sha256"), read.sha256, "64 digits, 0 to 9 and a to f");
  if (read.empty()) wrong(below(name), *json, "an object with a \"path\" or \"absolute_path\"");
  value = std::move(read);
}

void FieldReader::model(const char* name, int& index) {
  const ReadJson* const json = take(name);
  if (json == nullptr) return;
  double model = 0;
  if (*json == "joined") {
    index = kAllModels;
  } else if (number(below(name), *json, model, kModelRule)) {
    index = static_cast<int>(model) - 1;
  }
}

}  // namespace alphascope
