// SPDX-License-Identifier: GPL-3.0-or-later
// Settings as JSON. FieldWriter and FieldReader visit the fields of settings_fields.hpp. The reader
// checks all bounds, because files come from anywhere. This header compiles slowly, so only sources
// that read or write such files should include it.
#pragma once

#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/chart/colour_text.hpp"
#include "core/document/commands/number_input.hpp"
#include "core/document/picture/picture_options.hpp"
#include "core/document/reference/appearance.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/session/alpha_json.hpp"
#include "core/document/session/file_reference.hpp"
#include "core/document/session/json_place.hpp"
#include "core/document/session/setting_ids.hpp"
#include "core/document/settings/clip.hpp"
#include "core/document/settings/paint.hpp"
#include "core/molecule/sandbox.hpp"

namespace alphascope {

using WrittenJson = nlohmann::ordered_json;
using ReadJson = nlohmann::json;

class FieldWriter {
 public:
  explicit FieldWriter(WrittenJson& to) : to_(to) {}

  void operator()(const char* name, bool value) { to_[name] = value; }
  void operator()(const char* name, double value, const NumberRule&) { to_[name] = value; }
  void operator()(const char* name, const Alpha& value, const NumberRule&) { to_[name] = value; }
  void operator()(const char* name, float value, const NumberRule&);
  void operator()(const char* name, int value, const NumberRule&) { to_[name] = value; }
  void operator()(const char* name, const std::array<double, 3>& value, const NumberRule&) {
    to_[name] = value;
  }
  void operator()(const char* name, const std::string& value);
  void operator()(const char* name, const std::vector<std::string>& value);
  void operator()(const char* name, const std::filesystem::path& value);
  void operator()(const char* name, const std::vector<std::filesystem::path>& value);
  void operator()(const char* name, const std::vector<RadiusOverride>& value);
  void operator()(const char* name, const RefSet& value);
  void operator()(const char* name, const AtomSet& value);
  void operator()(const char* name, const std::vector<AtomRef>& value);
  void operator()(const char* name, const Rgb8& value);
  void operator()(const char* name, const PictureBackground& value);
  void operator()(const char* name, const FileReference& value);
  void operator()(const char* name, const Clip& value);
  void operator()(const char* name, const std::optional<Sandbox>& value);
  void operator()(const char* name, const Paint& value, PaintTarget what);
  void model(const char* name, int index);
  void formerly(const char*, const char*) {}
  template <class Choice>
  requires IsChoice<Choice>
  void operator()(const char* name, Choice value) {
    for (const auto& [choice, id] : setting_ids(value)) {
      if (choice == value) to_[name] = id;
    }
  }
  template <class T>
  void object(const char* name, T& value) {
    FieldWriter inner(to_[name] = WrittenJson::object());
    visit_fields(inner, value);
  }
  template <class T>
  void objects(const char* name, std::vector<T>& values) {
    WrittenJson& list = to_[name] = WrittenJson::array();
    for (T& value : values) {
      FieldWriter inner(list.emplace_back(WrittenJson::object()));
      visit_fields(inner, value);
    }
  }

 private:
  WrittenJson& to_;
};

// Errors and unknown names found while reading.
struct JsonFindings {
  struct Wrong {
    JsonPlace place;
    std::string reason;  // "is 7, and must be a number from 0.05 to 1"
  };
  std::vector<Wrong> wrong;
  std::vector<JsonPlace> unknown;
  struct Renamed {
    JsonPlace place;   // as it is in the file
    std::string note;  // follows the place: " is called "request" now. …"
  };
  std::vector<Renamed> renamed;
};

// Reads fields of an object. If a value is wrong, the field keeps its old value.
class FieldReader {
 public:
  static constexpr std::size_t kMostListed = 100000;
  FieldReader(const ReadJson& from, JsonPlace place, JsonFindings& findings)
      : from_(from), place_(std::move(place)), findings_(findings) {}

  void operator()(const char* name, bool& value);
  void operator()(const char* name, double& value, const NumberRule& rule);
  void operator()(const char* name, Alpha& value, const NumberRule& rule);  // a number or a text
  void operator()(const char* name, float& value, const NumberRule& rule);
  void operator()(const char* name, int& value, const NumberRule& rule);
  void operator()(const char* name, std::array<double, 3>& value, const NumberRule& rule);
  void operator()(const char* name, std::string& value);
  void operator()(const char* name, std::vector<std::string>& value);
  void operator()(const char* name, std::filesystem::path& value);
  void operator()(const char* name, std::vector<std::filesystem::path>& value);
  void operator()(const char* name, std::vector<RadiusOverride>& value);
  void operator()(const char* name, RefSet& value);
  void operator()(const char* name, AtomSet& value);
  void operator()(const char* name, std::vector<AtomRef>& value);  // 2 to 4, in this order
  void operator()(const char* name, Rgb8& value);
  void operator()(const char* name, PictureBackground& value);
  void operator()(const char* name, FileReference& value);
  void operator()(const char* name, Clip& value);
  void operator()(const char* name, std::optional<Sandbox>& value);
  void operator()(const char* name, Paint& value, PaintTarget what);
  void model(const char* name, int& index);
  // Lets the next calls read the member `now` under its older name, if it is there under no other.
  void formerly(const char* old, const char* now);
  template <class Choice>
  requires IsChoice<Choice>
  void operator()(const char* name, Choice& value) {
    const auto& ids = setting_ids(value);
    std::vector<std::string_view> words;
    for (const auto& [choice, id] : ids) words.push_back(id);
    const std::size_t chosen = choose(name, words);
    if (chosen < ids.size()) value = ids[chosen].first;
  }
  template <class T>
  void object(const char* name, T& value) {
    const ReadJson* const found = take_object(name);
    if (found == nullptr) return;
    FieldReader inner(*found, below(name), findings_);
    visit_fields(inner, value);
    inner.finish();
  }
  template <class T>
  void objects(const char* name, std::vector<T>& values) {
    const ReadJson* const found = take_list(name, kMostListed);
    if (found == nullptr) return;
    const std::size_t faults = findings_.wrong.size();
    std::vector<T> read(found->size());
    for (std::size_t i = 0; i < found->size(); ++i) {
      JsonPlace place = below(name);
      place.push_back(std::to_string(i));
      if (!(*found)[i].is_object()) return wrong(place, (*found)[i], "an object, in braces");
      FieldReader item((*found)[i], place, findings_);
      visit_fields(item, read[i]);
      item.finish();
    }
    if (findings_.wrong.size() == faults) values = std::move(read);
  }

  // Null if there is no such member.
  const ReadJson* take(const char* name);
  void wrong(JsonPlace place, const ReadJson& value, const std::string& must_be);
  // `reason` follows the place in the message: "cannot be understood".
  void fault(JsonPlace place, std::string reason);
  JsonPlace below(const std::string& name) const;
  // Reports members that no call has read as unknown.
  void finish();

 private:
  const ReadJson* take_object(const char* name);
  const ReadJson* take_list(const char* name, std::size_t most);
  const char* name_in_file(const char* name) const;
  std::size_t choose(const char* name, const std::vector<std::string_view>& words);
  bool number(const JsonPlace& place, const ReadJson& json, double& value, const NumberRule& rule);
  bool text(const JsonPlace& place, const ReadJson& json, std::string& value);
  bool atom(const JsonPlace& place, const ReadJson& json, AtomRef& value);

  const ReadJson& from_;
  JsonPlace place_;
  JsonFindings& findings_;
  std::set<std::string_view> taken_;
  std::map<std::string_view, const char*> former_;  // by the present name
};

// Text from a user or a file, as a string. If it is not UTF-8, as { "bytes": "c3a4" }.
WrittenJson text_json(const std::string& text);

// The object of a whole file. Throws ReadError with the line if it is not a JSON object, or nested
// too deeply. `what` is "session", `remedy` an advice.
ReadJson parse_json_object(const std::filesystem::path& path, std::string_view text,
                           const std::string& what, const std::string& remedy);

// The text of such a file; it ends with a newline.
std::string json_file_text(const WrittenJson& json);

}  // namespace alphascope
