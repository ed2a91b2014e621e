// What a program can be asked, as plain data: the parser, --help, the man page and the completion
// of shells are all made from this one table.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace alphascope {

// What an option prints instead of letting the program run.
enum class InsteadOfRunning : unsigned char { none, help, version, man_page, completion };

struct Option {
  std::string names;  // "-o,--output", short name first; without dashes ("FILE"): an argument
  // What it takes: a placeholder in capitals ("FILE", "OUT.png"), words to choose from
  // ("auto|keep|drop"), or both ("bondi|amber|FILE"). Empty: it is a flag.
  std::string value = {};
  std::string text = {};      // one sentence without full stop, with the unit
  std::string fallback = {};  // the default as people read it: "0 Å"; may be empty
  std::string group = {};     // heading in the help; empty: "Options"
  // Called once for each value, of a flag with "". Throws std::invalid_argument that says what is
  // wrong with the value.
  std::function<void(const std::string&)> set = {};
  bool required = false;
  bool list = false;  // takes "A,B" and may be given again; of an argument: takes any number
  // An empty value means something, such as the chain without a name. Else it is refused: it would
  // be as if the option had not been given.
  bool may_be_empty = false;
  InsteadOfRunning answer = InsteadOfRunning::none;

  bool is_flag() const { return value.empty(); }
  bool is_argument() const { return names.front() != '-'; }
  std::vector<std::string> all_names() const;  // "-o" and "--output"
  std::string shown_name() const;              // the last of them: "--output"
  std::vector<std::string> choices() const;    // the words of `value` in small letters
  bool takes_file() const;                     // a file or folder is among what it takes
  std::string shown_value() const;             // of a list with ",..." behind it
};

struct OptionCommand {
  std::string name, text;
  std::vector<Option> options;
  // Called when everything is set; throws std::invalid_argument for what does not go together.
  std::function<void()> check = {};
  InsteadOfRunning answer = InsteadOfRunning::none;
  std::vector<std::string> examples = {};  // whole lines, for the help
};

// A heading and lines that are shown as they are, in the help and the man page.
struct OptionNotes {
  std::string heading;
  std::vector<std::string> lines;
};

struct OptionProgram {
  std::string name, text, version;
  std::vector<Option> options;          // of the program itself
  std::vector<OptionCommand> commands;  // may be empty; else one of them must be named
  std::vector<OptionNotes> notes;
  int usage_exit_code = 2;

  const OptionCommand* find(const std::string& command) const;
  std::vector<std::string> command_names() const;
};

// Adds --help, --version, --man-page and --completion, the first two to each command as well, and
// the command `help` where there are commands.
void add_standard_options(OptionProgram& program);

// Every name of those that are no arguments: "-q", "--quiet".
std::vector<std::string> dashed_names(const std::vector<Option>& options);

}  // namespace alphascope
