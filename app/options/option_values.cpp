// SPDX-License-Identifier: GPL-3.0-or-later
// Makes options by the kind of their value, and checks values.
#include "app/options/option_values.hpp"

#include <charconv>
#include <cmath>
#include <stdexcept>

#include "app/options/did_you_mean.hpp"

namespace alphascope {
namespace {

// The shortest text that reads back as the same number.
std::string shortest(double number) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, number).ptr};
}

std::string with_unit(const std::string& number, const NumberRange& range) {
  return number + (range.unit.empty() ? "" : " " + range.unit);
}

std::string range_text(const NumberRange& range) {
  if (range.most >= kAnyNumber.most) return "a finite number";
  // Writes whole numbers above a million without an exponent, which is easier to read.
  const auto text = [](double bound) {
    return bound == std::floor(bound) && std::abs(bound) < 1e15
               ? std::to_string(static_cast<long long>(bound))
               : shortest(bound);
  };
  return "from " + text(range.least) + " to " + with_unit(text(range.most), range);
}

[[noreturn]] void refuse(const std::string& value, const std::string& expected) {
  throw std::invalid_argument("\"" + value + "\" is not " + expected);
}

template <class Number>
Number parse(const std::string& value, const NumberRange& range, const std::string& expected) {
  const char* const begin = value.data() + (value.starts_with('+') ? 1 : 0);
  const char* const end = value.data() + value.size();
  Number number{};
  const auto [stopped, error] = std::from_chars(begin, end, number);
  if (error != std::errc() || stopped != end || !std::isfinite(static_cast<double>(number)) ||
      static_cast<double>(number) < range.least || static_cast<double>(number) > range.most) {
    refuse(value, expected);
  }
  return number;
}

Option base(OptionText text) {
  return {
      .names = std::move(text.names), .value = std::move(text.value), .text = std::move(text.text)};
}

template <class Number>
std::string list_text(const std::vector<Number>& numbers) {
  std::string text;
  for (const Number number : numbers) {
    text += (text.empty() ? "" : ",") + shortest(static_cast<double>(number));
  }
  return text;
}

// Returns a function that collects values. The first one replaces the default, and later ones are
// added.
template <class T>
auto appending(std::vector<T>& target) {
  return [&target, fresh = true](T value) mutable {
    if (fresh) target.clear();
    fresh = false;
    target.push_back(std::move(value));
  };
}

}  // namespace

void require_choice(const std::string& value, const std::vector<std::string>& choices) {
  std::string known;
  for (const std::string& choice : choices) {
    if (value == choice) return;
    known += (known.empty() ? "" : ", ") + choice;
  }
  throw std::invalid_argument("\"" + value + "\" is not one of " + known + "." +
                              did_you_mean(value, choices));
}

double number_in(const std::string& value, const NumberRange& range) {
  const std::string kind = range.most >= kAnyNumber.most ? "" : "a number ";
  return parse<double>(value, range, kind + range_text(range));
}

int whole_number_in(const std::string& value, const NumberRange& range) {
  return parse<int>(value, range, "a whole number " + range_text(range));
}

Option flag_option(std::string names, std::string text, bool& target, bool given) {
  Option option{.names = std::move(names), .text = std::move(text)};
  option.set = [&target, given](const std::string&) { target = given; };
  return option;
}

Option text_option(OptionText text, std::string& target) {
  Option option = base(std::move(text));
  option.fallback = target;
  option.set = [&target](const std::string& value) { target = value; };
  return option;
}

Option path_option(OptionText text, std::filesystem::path& target) {
  Option option = base(std::move(text));
  option.set = [&target](const std::string& value) { target = value; };
  return option;
}

Option texts_option(OptionText text, std::vector<std::string>& target) {
  Option option = base(std::move(text));
  option.list = true;
  option.set = appending(target);
  return option;
}

Option choice_option(OptionText text, std::string& target) {
  Option option = text_option(std::move(text), target);
  option.set = [&target, choices = option.choices()](const std::string& value) {
    require_choice(value, choices);
    target = value;
  };
  return option;
}

Option choices_option(OptionText text, std::vector<std::string>& target) {
  Option option = texts_option(std::move(text), target);
  option.set = [add = appending(target),
                choices = option.choices()](const std::string& value) mutable {
    require_choice(value, choices);
    add(value);
  };
  return option;
}

Option number_option(OptionText text, double& target, const NumberRange& range) {
  Option option = base(std::move(text));
  option.fallback = with_unit(shortest(target), range);
  option.set = [&target, range](const std::string& value) { target = number_in(value, range); };
  return option;
}

Option whole_number_option(OptionText text, int& target, const NumberRange& range) {
  Option option = base(std::move(text));
  option.fallback = with_unit(std::to_string(target), range);
  option.set = [&target, range](const std::string& value) {
    target = whole_number_in(value, range);
  };
  return option;
}

Option numbers_option(OptionText text, std::vector<double>& target, const NumberRange& range) {
  Option option = base(std::move(text));
  option.list = true;
  option.fallback = target.empty() ? "" : with_unit(list_text(target), range);
  option.set = [add = appending(target), range](const std::string& value) mutable {
    add(number_in(value, range));
  };
  return option;
}

Option whole_numbers_option(OptionText text, std::vector<int>& target, const NumberRange& range) {
  Option option = base(std::move(text));
  option.list = true;
  option.fallback = target.empty() ? "" : with_unit(list_text(target), range);
  option.set = [add = appending(target), range](const std::string& value) mutable {
    add(whole_number_in(value, range));
  };
  return option;
}

Option with_default(Option option, std::string fallback) {
  option.fallback = std::move(fallback);
  return option;
}

Option in_group(Option option, std::string group) {
  option.group = std::move(group);
  return option;
}

Option may_be_empty(Option option) {
  option.may_be_empty = true;
  return option;
}

Option required(Option option) {
  option.required = true;
  option.fallback.clear();
  return option;
}

}  // namespace alphascope
