// SPDX-License-Identifier: GPL-3.0-or-later
// Access to the values of the settings of the display by the rows of their table.
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <type_traits>

#include "core/document/settings/display_fields.hpp"
#include "core/geometry/shortest_number.hpp"

namespace alphascope {
namespace {

using D = DisplaySettings;

template <class Value>
constexpr bool kIsPaint = std::is_same_v<std::remove_cvref_t<Value>, Paint>;

bool same(const DisplayField& field, const DisplaySettings& a, const DisplaySettings& b) {
  return std::visit([&](auto member) { return a.*member == b.*member; }, field.member);
}

std::string text_of(bool value) {
  return value ? "on" : "off";
}
std::string text_of(float value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}
std::string text_of(int value) {
  return std::to_string(value);
}
std::string text_of(const Paint& value) {
  return paint_text(value);
}

}  // namespace

const DisplayField& display_field(DisplayField::Member member) {
  for (const DisplayField& field : display_fields()) {
    if (field.member == member) return field;
  }
  throw std::logic_error("a setting of the display has no row in the table");
}

bool is_switch(const DisplayField& field) {
  return std::holds_alternative<bool D::*>(field.member);
}

bool is_paint(const DisplayField& field) {
  return std::holds_alternative<Paint D::*>(field.member);
}

bool is_number(const DisplayField& field) {
  return !is_switch(field) && !is_paint(field);
}

double number_of(const DisplayField& field, const DisplaySettings& display) {
  return std::visit(
      [&](auto member) -> double {
        if constexpr (kIsPaint<decltype(display.*member)>) {
          throw std::logic_error("a paint is no number");
        } else {
          return static_cast<double>(display.*member);
        }
      },
      field.member);
}

void set_number(const DisplayField& field, DisplaySettings& display, double value) {
  std::visit(
      [&](auto member) {
        using Value = std::remove_cvref_t<decltype(display.*member)>;
        if constexpr (kIsPaint<Value>) {
          throw std::logic_error("a paint is no number");
        } else if constexpr (std::is_same_v<Value, int>) {
          display.*member = static_cast<int>(std::lround(value));
        } else if constexpr (std::is_same_v<Value, bool>) {
          display.*member = value != 0;
        } else {
          display.*member = static_cast<Value>(value);
        }
      },
      field.member);
}

std::string value_text(const DisplayField& field, const DisplaySettings& display) {
  return std::visit([&](auto member) { return text_of(display.*member); }, field.member);
}

std::string range_text(const DisplayField& field) {
  const NumberRule& rule = field.rule;
  return shortest_number(rule.least) + " to " + shortest_number(rule.most);
}

std::string name_of(const DisplayField& field) {
  std::string name = field.title;
  name.front() = static_cast<char>(name.front() - 'A' + 'a');
  return name;
}

void copy_group(DisplayGroup group, const DisplaySettings& from, DisplaySettings& to) {
  for (const DisplayField& field : display_fields()) {
    if (field.group != group) continue;
    std::visit([&](auto member) { to.*member = from.*member; }, field.member);
  }
}

std::string command_of(const BesideKind& kind) {
  return std::string("view.left_out_") + kind.id;
}

std::string difference_of(const DisplaySettings& a, const DisplaySettings& b) {
  if (a == b) return {};
  std::string name;
  const auto note = [&name](const std::string& differs) {
    name = name.empty() ? differs : "display";
  };
  for (const DisplayField& field : display_fields()) {
    if (!same(field, a, b)) note(name_of(field));
  }
  if (a.beside != b.beside) note("atoms beside the body");
  return name;
}

}  // namespace alphascope
