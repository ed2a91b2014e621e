// SPDX-License-Identifier: GPL-3.0-or-later
// Checks commands, reads their arguments and runs them.
#include "core/document/commands/commands.hpp"

#include <algorithm>
#include <new>
#include <stdexcept>

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/text/letter_case.hpp"

namespace alphascope {
namespace {

using Kind = Parameter::Kind;

std::string_view without_blanks(std::string_view text) {
  constexpr const char* kBlanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

bool is_quote(char c) {
  return c == '"' || c == '\'';
}

// Removes the first word from `rest`. Returns false if its quote has no end.
bool take_word(std::string_view& rest, std::string& word) {
  rest = without_blanks(rest);
  std::size_t end = rest.find_first_of(" \t");
  if (!rest.empty() && is_quote(rest.front())) {
    end = rest.find(rest.front(), 1);
    if (end == std::string_view::npos) return false;
    word = rest.substr(1, end - 1);
    rest = without_blanks(rest.substr(end + 1));
    return true;
  }
  word = rest.substr(0, end);
  rest = without_blanks(rest.substr(std::min(rest.size(), word.size())));
  return true;
}

bool takes_the_rest(const Parameter& p) {
  return p.kind == Kind::number || p.kind == Kind::text || p.kind == Kind::path;
}

std::string ids_of(const std::vector<Choice>& choices) {
  std::string text;
  for (const Choice& choice : choices) text += (text.empty() ? "" : ", ") + choice.id;
  return text;
}

std::string what_is_needed(const Parameter& p) {
  if (p.kind == Kind::choice) {
    const std::vector<Choice> choices = p.choices();
    if (choices.empty()) return "a " + p.name + ", and there is none now";
    return "one of " + ids_of(choices);
  }
  if (p.kind == Kind::path) return "a path";
  if (p.kind == Kind::text) return "a " + p.name;
  const std::string unit = p.unit();
  return std::string("a ") + (p.rule && p.rule->whole ? "whole " : "") + "number" +
         (unit.empty() ? "" : " in " + unit);
}

// "on|off", or the name of the parameter if that would be long.
std::string choice_usage(const Parameter& p) {
  constexpr std::size_t kMostShown = 6;
  const std::vector<Choice> choices = p.choices();
  if (choices.empty() || choices.size() > kMostShown) return upper_case(p.name);
  std::string text;
  for (const Choice& choice : choices) text += (text.empty() ? "" : "|") + choice.id;
  return text;
}

// "alpha.set needs a number in Å², such as alpha.set 1.4".
std::string lacks(const CommandSpec& spec, const Parameter& p) {
  std::string text = spec.id + " needs " + what_is_needed(p);
  if (p.example.empty()) return text + ".";
  std::string line = spec.id;
  for (const Parameter& before : spec.parameters) {
    if (!before.example.empty()) line += " " + before.example;
    if (before.name == p.name) break;
  }
  return text + ", such as " + line;
}

std::string too_many(const CommandSpec& spec, const std::string& word) {
  return spec.id + (spec.parameters.empty() ? " takes no arguments" : " takes fewer arguments") +
         ": \"" + word + "\" is too much. Write " + spec.usage() + ".";
}

// Reads the text as a value of the parameter. Returns a sentence with the reason if that fails,
// otherwise an empty string.
std::string read_value(const CommandSpec& spec, const Parameter& p, Arguments::Value& value) {
  if (p.kind == Kind::number) {
    const NumberInput input = read_number(value.text, *p.rule);
    value.number = input.value.value_or(0);
    return input.value ? "" : spec.id + ": " + input.error;
  }
  if (value.text.empty()) return lacks(spec, p);
  if (p.kind != Kind::choice) return {};
  const std::vector<Choice> known = p.choices();
  const bool found = std::any_of(known.begin(), known.end(),
                                 [&](const Choice& choice) { return choice.id == value.text; });
  return found ? "" : spec.id + ": \"" + value.text + "\" is not one of " + ids_of(known) + ".";
}

void check(const CommandSpec& spec) {
  const auto bad = [&spec](const char* why) {
    throw std::logic_error("the command \"" + spec.id + "\" " + why);
  };
  if (spec.id.empty() || spec.id.find_first_of(" \t\"'") != std::string::npos) bad("has no id");
  if (spec.title.empty() || spec.help.empty()) bad("has no title or no help");
  if (!spec.run) bad("does nothing");
  if (!spec.menu.empty() && std::find(kMenus.begin(), kMenus.end(), spec.menu) == kMenus.end()) {
    bad("is in a menu that does not exist");
  }
  bool optional = false;
  for (const Parameter& p : spec.parameters) {
    if (p.kind == Kind::number && !p.rule) bad("has a number without bounds");
    if (p.kind == Kind::choice && !p.choices) bad("has nothing to choose from");
    const bool may_lack = p.optional || p.kind == Kind::flag;
    if (optional && !may_lack) bad("has a required parameter behind an optional one");
    optional |= may_lack;
  }
}

}  // namespace

std::string Parameter::what_to_type() const {
  std::string text = help;
  if (*unit() != '\0') text += std::string(", in ") + unit();
  if (example.empty() || help.find("such as ") != std::string::npos) return text;
  return text + ", such as " + example;
}

double Arguments::number(std::string_view name, double otherwise) const {
  const auto it = values_.find(name);
  return it == values_.end() ? otherwise : it->second.number;
}

std::string Arguments::text(std::string_view name, std::string otherwise) const {
  const auto it = values_.find(name);
  if (it == values_.end()) return otherwise;
  return it->second.text;
}

const Parameter* CommandSpec::first_required() const {
  const bool required =
      !parameters.empty() && !parameters[0].optional && parameters[0].kind != Parameter::Kind::flag;
  return required ? parameters.data() : nullptr;
}

std::string CommandSpec::usage() const {
  std::string text = id;
  for (const Parameter& p : parameters) {
    const bool flag = p.kind == Kind::flag;
    const std::string name = flag                     ? p.name
                             : p.kind == Kind::choice ? choice_usage(p)
                                                      : upper_case(p.name);
    text += flag || p.optional ? " [" + name + "]" : " " + name;
  }
  return text;
}

std::string CommandSpec::shortcuts_text() const {
  std::string text;
  for (const Shortcut& s : shortcuts) {
    if (s.arguments.empty()) text += (text.empty() ? "" : ", ") + s.keys;
  }
  return text;
}

void Commands::add(CommandSpec spec) {
  check(spec);
  if (find(spec.id)) throw std::logic_error("the command \"" + spec.id + "\" has been added twice");
  for (auto s = spec.shortcuts.begin(); s != spec.shortcuts.end(); ++s) {
    const auto same = [keys = upper_case(s->keys)](const Shortcut& t) {
      return upper_case(t.keys) == keys;
    };
    bool taken = std::any_of(spec.shortcuts.begin(), s, same);
    for (const CommandSpec& other : specs_) {
      taken |= std::any_of(other.shortcuts.begin(), other.shortcuts.end(), same);
    }
    if (taken) {
      throw std::logic_error("the shortcut " + s->keys + " of \"" + spec.id + "\" is taken");
    }
  }
  specs_.push_back(std::move(spec));
}

const CommandSpec* Commands::find(std::string_view id) const {
  const auto it =
      std::find_if(specs_.begin(), specs_.end(), [&](const CommandSpec& s) { return s.id == id; });
  return it == specs_.end() ? nullptr : &*it;
}

Commands::Reading Commands::read(const CommandSpec& spec, const std::vector<std::string>& words) {
  Reading reading;
  auto& values = reading.arguments.values_;
  auto next = spec.parameters.begin();
  const auto end = spec.parameters.end();
  const auto skip_flags = [&] {
    while (next != end && next->kind == Kind::flag) ++next;
  };
  for (const std::string& word : words) {
    const auto flag = std::find_if(spec.parameters.begin(), end, [&](const Parameter& p) {
      return p.kind == Kind::flag && p.name == word;
    });
    if (flag != end) {
      values[word].text = word;
      continue;
    }
    skip_flags();
    if (next == end) {
      reading.error = too_many(spec, word);
      return reading;
    }
    Arguments::Value value{word};
    reading.error = read_value(spec, *next, value);
    if (!reading.error.empty()) return reading;
    values[next->name] = std::move(value);
    ++next;
  }
  skip_flags();
  if (next != end && !next->optional) {
    reading.missing = &*next;
    reading.error = lacks(spec, *next);
  }
  return reading;
}

CommandLine Commands::parse_words(const CommandSpec& spec, std::string_view arguments) {
  CommandLine line{spec.id, {}, {}};
  const auto& parameters = spec.parameters;
  std::string_view rest = without_blanks(arguments);
  while (!rest.empty()) {
    const bool last = line.words.size() + 1 == parameters.size();
    const bool quoted = is_quote(rest.front());
    if (last && takes_the_rest(parameters.back()) &&
        !(quoted && parameters.back().kind == Kind::path)) {
      line.words.emplace_back(rest);
      break;
    }
    std::string word;
    if (!take_word(rest, word)) {
      line.error = "The quotes in \"" + std::string(rest) + "\" do not end.";
      break;
    }
    line.words.push_back(std::move(word));
  }
  return line;
}

CommandLine Commands::parse_line(std::string_view text) const {
  std::string_view rest = without_blanks(text);
  const std::string id(rest.substr(0, rest.find_first_of(" \t")));
  rest.remove_prefix(id.size());
  if (const CommandSpec* const spec = find(id)) return parse_words(*spec, rest);
  return {id, {}, "There is no command \"" + id + "\"."};
}

Outcome Commands::run(std::string_view id, const std::vector<std::string>& words) const {
  const CommandSpec* const spec = find(id);
  if (spec == nullptr) {
    return Outcome::refused("There is no command \"" + std::string(id) + "\".");
  }
  try {
    if (std::string why = spec->reason_against(); !why.empty()) return Outcome::refused(why);
    const Reading reading = read(*spec, words);
    if (!reading.error.empty()) return Outcome::refused(reading.error);
    return spec->run(reading.arguments);
  } catch (const std::bad_alloc&) {
    return Outcome::failed("There is not enough memory. Close other programs and try again.",
                           std::current_exception());
  } catch (const std::exception& error) {
    return Outcome::failed(error.what(), std::current_exception());
  }
}

Outcome Commands::run_line(std::string_view text) const {
  const CommandLine line = parse_line(text);
  return line.error.empty() ? run(line.id, line.words) : Outcome::refused(line.error);
}

}  // namespace alphascope
