// SPDX-License-Identifier: GPL-3.0-or-later
// The list of all commands of the window. Menus, keyboard shortcuts, the cheat sheet, the command
// palette and scripts are made from it. So a new command needs one call of add(). No GUI type.
#pragma once

#include <array>
#include <cstdint>
#include <exception>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/commands/number_input.hpp"

namespace alphascope {

// The menus, from left to right. Menus without commands are not shown.
inline constexpr std::array<std::string_view, 5> kMenus{"File", "Edit", "View", "Tools", "Help"};

struct Choice {
  std::string id, title;    // "cpu" as typed, "Dual-edge engine, CPU" as shown
  std::string detail = {};  // shown beside the title
  bool chosen = false;      // it is the present setting
};

struct Parameter {
  // A flag is set by writing its name, and is always optional.
  enum class Kind : std::uint8_t { number, text, choice, path, flag };
  std::string name;  // "alpha": one word
  Kind kind = Kind::text;
  std::string help = {};  // meaning of the value; a sentence without full stop
  std::string example = {};
  bool optional = false;
  std::optional<NumberRule> rule = {};                // a number's bounds and unit
  std::function<std::vector<Choice>()> choices = {};  // the present options of a choice

  const char* unit() const { return rule ? rule->unit : ""; }
  // The help with unit and example, if it does not contain them: "Alpha, in Å², such as 1.4".
  std::string what_to_type() const;
};

// The given values of the parameters, already checked.
class Arguments {
 public:
  struct Value {
    std::string text;
    double number = 0;
  };
  bool has(std::string_view name) const { return values_.contains(name); }
  double number(std::string_view name, double otherwise = 0) const;
  std::string text(std::string_view name, std::string otherwise = {}) const;

 private:
  friend class Commands;
  std::map<std::string, Value, std::less<>> values_;
};

struct Outcome {
  // refused: nothing was tried. failed: it was tried without success.
  enum class State : std::uint8_t { done, refused, failed, cancelled };
  State state = State::done;
  std::string why = {};           // a sentence; empty when done
  std::exception_ptr cause = {};  // what was thrown; null: nothing was

  bool done() const { return state == State::done; }
  static Outcome refused(std::string why) { return {State::refused, std::move(why)}; }
  static Outcome failed(std::string why, std::exception_ptr cause = {}) {
    return {State::failed, std::move(why), std::move(cause)};
  }
};

// Keys that run a command, perhaps with arguments: "Ctrl+Shift+Z", "Right", "Esc", "R".
struct Shortcut {
  std::string keys;
  std::string arguments = {};
};

// Other words for the command, by which users may search it, and the arguments that these words
// stand for.
struct Synonym {
  std::string words;  // "image screenshot"
  std::string arguments = {};
};

struct CommandSpec {
  std::string id;     // "view.reset": an area and a verb
  std::string title;  // "Reset view"; ends with "…" when a dialog opens
  std::string help;   // a sentence without full stop
  std::vector<Synonym> synonyms = {};
  std::vector<Shortcut> shortcuts = {};
  // Keys that run this command while it can run, although they are shortcuts of another command at
  // other times.
  std::vector<Shortcut> keys_before_others = {};
  bool works_everywhere = false;  // shortcuts also work while text is typed, and above dialogs
  std::string menu = {};          // one of kMenus; empty: in no menu
  bool line_above = false;        // in the menu, a line above the entry
  std::vector<Parameter> parameters = {};
  std::function<std::string()> why_not = {};  // returns a sentence; empty result or no function: it
                                              // can run
  std::function<bool()> checked = {};         // for a switch: returns whether it is on
  std::function<Outcome(const Arguments&)> run = {};

  // A switch can be set to on and off.
  bool is_switch() const { return checked && !parameters.empty(); }
  std::string reason_against() const { return why_not ? why_not() : std::string(); }
  // The first required parameter; null: none.
  const Parameter* first_required() const;
  std::string usage() const;           // "file.save_picture [PATH] [WIDTH] [transparent]"
  std::string shortcuts_text() const;  // "Ctrl+Shift+Z, Ctrl+Y": the shortcuts without arguments
};

// A line of a script, split into words.
struct CommandLine {
  std::string id;
  std::vector<std::string> words;
  std::string error;  // a sentence; empty: none
};

class Commands {
 public:
  // Throws std::logic_error if the id or a shortcut exists already, or if the spec is incomplete.
  void add(CommandSpec spec);

  const std::vector<CommandSpec>& all() const { return specs_; }  // in the order of add()
  const CommandSpec* find(std::string_view id) const;

  // The words as values of this command's parameters. `missing` is the first required parameter
  // without a value.
  struct Reading {
    Arguments arguments;
    std::string error;  // a sentence with an example; empty: none
    const Parameter* missing = nullptr;
  };
  static Reading read(const CommandSpec& spec, const std::vector<std::string>& words);

  // Splits a line such as "alpha.set 1.4" or "file.save_picture "my picture.png" 800 600". The last
  // parameter takes the rest of the line, so that a path with blanks needs no quotes there.
  CommandLine parse_line(std::string_view line) const;
  static CommandLine parse_words(const CommandSpec& spec, std::string_view arguments);

  // Never throws: an exception of the command becomes its failure.
  Outcome run(std::string_view id, const std::vector<std::string>& words = {}) const;
  Outcome run_line(std::string_view line) const;

 private:
  std::vector<CommandSpec> specs_;
};

}  // namespace alphascope
