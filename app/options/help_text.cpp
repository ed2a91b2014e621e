// SPDX-License-Identifier: GPL-3.0-or-later
// Lays out the help in columns.
#include "app/options/help_text.hpp"

#include <algorithm>

#include "core/text/text_parts.hpp"

namespace alphascope {
namespace {

constexpr std::size_t kWidth = 100;      // columns of a line
constexpr std::size_t kTextColumn = 32;  // where the explanations begin

constexpr char kUnbroken = '\x1F';  // replaces a blank at which no line may break

// Columns of a text: its number of UTF-8 characters.
std::size_t columns(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

// Lays out "left   explanation" with wrapped lines. A long `left` gets a line of its own.
std::string entry(const std::string& left, const std::string& explanation) {
  std::string line = "  " + left, text;
  if (columns(line) + 2 > kTextColumn) {
    text = line + "\n";
    line.clear();
  }
  bool blank = true;  // no word of the explanation is on the line yet
  line.append(kTextColumn - std::min(kTextColumn, columns(line)), ' ');
  for (const std::string& word : words_of(explanation)) {
    if (!blank && columns(line) + 1 + columns(word) > kWidth) {
      text += line + "\n";
      line.assign(kTextColumn, ' ');
      blank = true;
    }
    line += (blank ? "" : " ") + word;
    blank = false;
  }
  text += line + "\n";
  std::replace(text.begin(), text.end(), kUnbroken, ' ');
  return text;
}

std::string explanation(const Option& option) {
  std::string text = option.text;
  if (option.required && !option.is_argument()) text += " (required)";
  if (option.fallback.empty()) return text;
  std::string fallback = "(default: " + option.fallback + ")";
  std::replace(fallback.begin(), fallback.end(), ' ', kUnbroken);
  return text + " " + fallback;
}

std::string left_column(const Option& option) {
  if (option.is_argument()) return option.names + (option.list ? "..." : "");
  std::string names;
  for (const std::string& name : option.all_names()) names += (names.empty() ? "" : ", ") + name;
  return names + (option.is_flag() ? "" : " " + option.shown_value());
}

std::string option_lists(const std::vector<Option>& options) {
  std::vector<std::string> headings;
  const auto heading = [](const Option& option) {
    return option.is_argument() ? "Arguments" : option.group.empty() ? "Options" : option.group;
  };
  for (const Option& option : options) {
    const std::string name = heading(option);
    if (std::find(headings.begin(), headings.end(), name) == headings.end()) {
      headings.push_back(name);
    }
  }
  std::string text;
  for (const std::string& name : headings) {
    text += "\n" + name + ":\n";
    for (const Option& option : options) {
      if (heading(option) == name) text += entry(left_column(option), explanation(option));
    }
  }
  return text;
}

std::string notes_text(const OptionNotes& notes) {
  std::string text = "\n" + notes.heading + ":\n";
  for (const std::string& line : notes.lines) text += "  " + line + "\n";
  return text;
}

}  // namespace

std::string usage_line(const OptionProgram& program, const OptionCommand* command) {
  std::string text = program.name;
  if (command != nullptr) text += " " + command->name;
  if (command == nullptr && !program.commands.empty()) return text + " COMMAND [OPTIONS] FILE...";
  for (const Option& option : command ? command->options : program.options) {
    if (option.required && !option.is_argument()) {
      text += " " + option.shown_name() + " " + option.shown_value();
    }
  }
  text += " [OPTIONS]";
  for (const Option& option : command ? command->options : program.options) {
    if (!option.is_argument()) continue;
    const std::string name = option.names + (option.list ? "..." : "");
    text += option.required ? " " + name : " [" + name + "]";
  }
  return text;
}

std::string help_text(const OptionProgram& program, const OptionCommand* command) {
  std::string text = (command ? command->text : program.text) + "\n\nUsage: ";
  text += usage_line(program, command) + "\n";
  if (command == nullptr && !program.commands.empty()) {
    text += "\nCommands (each has --help):\n";
    for (const OptionCommand& c : program.commands) text += entry(c.name, c.text);
  }
  text += option_lists(command ? command->options : program.options);
  if (command != nullptr) {
    if (!command->examples.empty()) text += notes_text({"Examples", command->examples});
    return text + "\nUnits and exit codes: " + program.name + " --help\n";
  }
  for (const OptionNotes& notes : program.notes) text += notes_text(notes);
  return text;
}

}  // namespace alphascope
