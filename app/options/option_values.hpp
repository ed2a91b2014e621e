// Options by the kind of their value: each sets a variable and shows what that held as the default.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/options/option_table.hpp"

namespace alphascope {

// Names, placeholder and help of an option that is made below.
struct OptionText {
  std::string names, value, text;
};

// Sets `target` to `given`.
Option flag_option(std::string names, std::string text, bool& target, bool given = true);
Option text_option(OptionText text, std::string& target);
Option path_option(OptionText text, std::filesystem::path& target);
// Any of "A,B", which may be given more than once.
Option texts_option(OptionText text, std::vector<std::string>& target);
// One of the words of `value`, which is in small letters: "auto|keep|drop".
Option choice_option(OptionText text, std::string& target);
Option choices_option(OptionText text, std::vector<std::string>& target);
// From `least` to `most`; `unit` is shown behind the default.
struct NumberRange {
  double least, most;
  std::string unit = {};
};
inline const NumberRange kAnyNumber{-1e308, 1e308};
Option number_option(OptionText text, double& target, const NumberRange& range);
Option whole_number_option(OptionText text, int& target, const NumberRange& range);
Option numbers_option(OptionText text, std::vector<double>& target, const NumberRange& range);
Option whole_numbers_option(OptionText text, std::vector<int>& target, const NumberRange& range);

// The same with a default that says more than the value does ("0 = all").
Option with_default(Option option, std::string fallback);
Option in_group(Option option, std::string group);
Option may_be_empty(Option option);
Option required(Option option);

// What is wrong with a value, unless it is one of `choices`; throws std::invalid_argument.
void require_choice(const std::string& value, const std::vector<std::string>& choices);
// Throws std::invalid_argument.
double number_in(const std::string& value, const NumberRange& range);
int whole_number_in(const std::string& value, const NumberRange& range);

}  // namespace alphascope
