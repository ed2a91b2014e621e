// SPDX-License-Identifier: GPL-3.0-or-later
// Parses a file into one JSON object, and finds the line of an error.
#include <set>
#include <utility>

#include "core/document/session/json_fields.hpp"
#include "core/files/read_error.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/name_table.hpp"
#include "core/selection/selection_expression.hpp"

namespace alphascope {
namespace {

constexpr std::size_t kDeepest = 40;  // our files have 6 levels

// Finds the place of a syntax error, since the parser's message counts bytes only. It also finds a
// name that occurs twice in an object: parsers use one of the values, but not all the same one.
class Faults : public ReadJson::json_sax_t {
 public:
  std::size_t offset = 0;
  JsonPlace twice;  // empty: no name occurs twice

  bool null() override { return value(); }
  bool boolean(bool) override { return value(); }
  bool number_integer(number_integer_t) override { return value(); }
  bool number_unsigned(number_unsigned_t) override { return value(); }
  bool number_float(number_float_t, const string_t&) override { return value(); }
  bool string(string_t&) override { return value(); }
  bool binary(binary_t&) override { return value(); }
  bool start_object(std::size_t) override { return begin(false); }
  bool end_object() override { return end(); }
  bool start_array(std::size_t) override { return begin(true); }
  bool end_array() override { return end(); }
  bool key(string_t& name) override {
    levels_.back().name = name;
    if (levels_.back().names.insert(name).second || !twice.empty()) return true;
    for (const Level& level : levels_) {
      twice.push_back(level.is_list ? std::to_string(level.index) : level.name);
    }
    return true;
  }
  bool parse_error(std::size_t position, const std::string&, const ReadJson::exception&) override {
    offset = position > 0 ? position - 1 : 0;
    return false;
  }

 private:
  struct Level {
    bool is_list;
    std::size_t index = 0;
    std::string name = {};
    std::set<std::string> names = {};
  };

  bool value() {
    if (!levels_.empty()) ++levels_.back().index;
    return true;
  }
  bool begin(bool is_list) {
    levels_.push_back({is_list});
    return true;
  }
  bool end() {
    levels_.pop_back();
    return value();
  }

  std::vector<Level> levels_;
};

}  // namespace

ReadJson parse_json_object(const std::filesystem::path& path, std::string_view text,
                           const std::string& what, const std::string& remedy) {
  std::size_t offset = 0;
  if (nested_deeper_than(text, kDeepest, offset)) {
    throw ReadError(path, line_at(text, offset),
                    "more than " + std::to_string(kDeepest) +
                        " lists and objects are nested here, which is too deep for a " + what,
                    remedy);
  }
  Faults faults;
  if (!ReadJson::sax_parse(text, &faults)) {
    throw ReadError(path, line_at(text, faults.offset),
                    "this is not a " + what + ": invalid JSON from here on", remedy);
  }
  if (!faults.twice.empty()) {
    throw ReadError(path, line_of(text, faults.twice),
                    "\"" + place_text(faults.twice) + "\" occurs twice", "Take one of them out");
  }
  ReadJson json = ReadJson::parse(text);
  if (!json.is_object()) {
    throw ReadError(path, 1, "this is not a " + what + ": the JSON file has another content",
                    remedy);
  }
  return json;
}

}  // namespace alphascope
