// SPDX-License-Identifier: GPL-3.0-or-later
// The options of a program as plain data. The parser, --help, the manual page and the shells'
// completion are made from this one table.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace alphascope {

// The text that an option or command prints, instead of a run of the program.
enum class InsteadOfRunning : unsigned char { none, help, version, man_page, completion };

struct Option {
  std::string names;  // "-o,--output", short name first; without dashes ("FILE"): an argument
  // The value: a placeholder in capitals ("FILE", "OUT.png"), words to choose from
  // ("auto|keep|drop"), or both ("bondi|amber|FILE"). Empty for a flag.
  std::string value = {};
  std::string text = {};      // one sentence without full stop, with the unit
  std::string fallback = {};  // the default for the help, such as "0 Å"; may be empty
  std::string group = {};     // heading in the help; empty: "Options"
  // Called once for each value, with "" for a flag. Throws std::invalid_argument that says what is
  // wrong with the value.
  std::function<void(const std::string&)> set = {};
  bool required = false;
  bool list = false;  // takes "A,B" and may be repeated; an argument: takes any number
  // Whether an empty value is valid, as for the chain without a name. Other options refuse it,
  // since it would have no effect.
  bool may_be_empty = false;
  InsteadOfRunning answer = InsteadOfRunning::none;

  bool is_flag() const { return value.empty(); }
  bool is_argument() const { return names.front() != '-'; }
  std::vector<std::string> all_names() const;  // such as "-o" and "--output"
  std::string shown_name() const;              // the last name, such as "--output"
  std::vector<std::string> choices() const;    // the lower-case words of `value`
  bool takes_file() const;                     // whether `value` allows a file or folder
  std::string shown_value() const;             // for a list with ",..." at its end
};

struct OptionCommand {
  std::string name, text;
  std::vector<Option> options;
  // Called after all options are set. Throws std::invalid_argument for options that exclude each
  // other.
  std::function<void()> check = {};
  InsteadOfRunning answer = InsteadOfRunning::none;
  std::vector<std::string> examples = {};  // whole lines, for the help
};

// A heading and unchanged lines, for the help and the manual page.
struct OptionNotes {
  std::string heading;
  std::vector<std::string> lines;
};

// A file or a variable of the environment, for the manual page.
struct ManualEntry {
  std::string name, text;  // `text`: sentences without the last full stop
};

struct OptionProgram {
  std::string name, text, version;
  std::vector<Option> options;          // of the program itself
  std::vector<OptionCommand> commands;  // if not empty, one of them must be named
  std::vector<OptionNotes> notes;
  // For the manual page only; each may be empty.
  std::string date;  // of this version: "2026-11-27"
  std::vector<ManualEntry> files, environment;
  std::vector<std::string> see_also;  // such as "alphascope(1)"
  int usage_exit_code = 2;

  const OptionCommand* find(const std::string& command) const;
  std::vector<std::string> command_names() const;
};

// Adds --help, --version, --man-page and --completion. The first two are added to each command as
// well. A program with commands also gets the command `help`.
void add_standard_options(OptionProgram& program);

// All names that start with a dash, such as "-q" and "--quiet".
std::vector<std::string> dashed_names(const std::vector<Option>& options);

}  // namespace alphascope
