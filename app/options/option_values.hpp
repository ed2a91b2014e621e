// SPDX-License-Identifier: GPL-3.0-or-later
// Makes options by the kind of their value. Each option sets a variable, whose present value is the
// default.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/options/option_table.hpp"

namespace alphascope {

// Names, placeholder and help of an option, for the functions below.
struct OptionText {
  std::string names, value, text;
};

// Sets `target` to `given`.
Option flag_option(std::string names, std::string text, bool& target, bool given = true);
Option text_option(OptionText text, std::string& target);
Option path_option(OptionText text, std::filesystem::path& target);
// Takes any words, as "A,B" or by repetition.
Option texts_option(OptionText text, std::vector<std::string>& target);
// Takes one of the lower-case words of `value`, such as "auto|keep|drop".
Option choice_option(OptionText text, std::string& target);
Option choices_option(OptionText text, std::vector<std::string>& target);
// Bounds of a number. The help shows `unit` after the default.
struct NumberRange {
  double least, most;
  std::string unit = {};
};
inline const NumberRange kAnyNumber{-1e308, 1e308};
Option number_option(OptionText text, double& target, const NumberRange& range);
Option whole_number_option(OptionText text, int& target, const NumberRange& range);
Option numbers_option(OptionText text, std::vector<double>& target, const NumberRange& range);
Option whole_numbers_option(OptionText text, std::vector<int>& target, const NumberRange& range);

// The same option with another text for its default, such as "0 = all".
Option with_default(Option option, std::string fallback);
Option in_group(Option option, std::string group);
Option may_be_empty(Option option);
Option required(Option option);

// Throws std::invalid_argument unless `value` is one of `choices`.
void require_choice(const std::string& value, const std::vector<std::string>& choices);
// Both throw std::invalid_argument for text that is not a number in the range.
double number_in(const std::string& value, const NumberRange& range);
int whole_number_in(const std::string& value, const NumberRange& range);

}  // namespace alphascope
