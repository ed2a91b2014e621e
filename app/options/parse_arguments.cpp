// SPDX-License-Identifier: GPL-3.0-or-later
// Parses arguments with CLI11, and replaces the texts of its errors.
#include "app/options/parse_arguments.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <stdexcept>

#include "app/options/completion.hpp"
#include "app/options/did_you_mean.hpp"
#include "app/options/help_text.hpp"
#include "app/options/man_page.hpp"
#include "app/options/option_values.hpp"

namespace alphascope {
namespace {

// Marks words after "--". Otherwise CLI11 would not add them to a list that began before "--".
constexpr char kBehindDashes = '\x01';

// Thrown while parsing, when --help or a similar option is found. Its text is printed.
struct Answered {
  std::string text;
};

std::string answer(const OptionProgram& program, const OptionCommand* command, const Option& option,
                   const std::string& value) {
  switch (option.answer) {
    case InsteadOfRunning::help:
      if (option.is_argument()) {
        require_choice(value, option.choices());
        return help_text(program, program.find(value));
      }
      return help_text(program, command);
    case InsteadOfRunning::version:
      return program.name + " " + program.version + "\n";
    case InsteadOfRunning::man_page:
      return man_page(program);
    case InsteadOfRunning::completion:
      require_choice(value, option.choices());
      return completion_script(program, value);
    case InsteadOfRunning::none:
      break;
  }
  return {};
}

std::vector<std::string> values_of(const Option& option, const std::string& given) {
  if (option.is_argument()) return {given.substr(given.starts_with(kBehindDashes) ? 1 : 0)};
  if (!option.list) return {given};
  std::vector<std::string> values;
  std::size_t begin = 0;
  for (std::size_t comma; (comma = given.find(',', begin)) != given.npos; begin = comma + 1) {
    values.push_back(given.substr(begin, comma - begin));
  }
  values.push_back(given.substr(begin));
  return values;
}

// The message about an empty value.
std::string empty_value(const Option& option, std::size_t of_values) {
  if (of_values > 1) return "there is nothing between two commas; leave the comma out";
  const std::string wanted =
      option.shown_value().find(' ') == std::string::npos ? option.shown_value() : "one";
  if (option.is_argument()) return "the name is empty; give the name of a file";
  return "the value is empty; give " + wanted +
         (option.required ? "" : ", or leave " + option.shown_name() + " out");
}

void give(const OptionProgram& program, const OptionCommand* command, const Option& option,
          const std::string& given) {
  if (option.answer == InsteadOfRunning::help && option.is_argument()) {
    try {
      throw Answered{answer(program, command, option, values_of(option, given).front())};
    } catch (const std::invalid_argument& error) {
      throw CLI::ValidationError(option.shown_name(), error.what());
    }
  }
  if (option.answer != InsteadOfRunning::none)
    throw Answered{answer(program, command, option, given)};
  const std::vector<std::string> values = values_of(option, given);
  for (const std::string& value : values) {
    try {
      if (value.empty() && !option.is_flag() && !option.may_be_empty) {
        throw std::invalid_argument(empty_value(option, values.size()));
      }
      option.set(value);
    } catch (const std::invalid_argument& error) {
      throw CLI::ValidationError(option.shown_name(), error.what());
    }
  }
}

void add(CLI::App& app, const OptionProgram& program, const OptionCommand* command,
         const Option& option) {
  if (option.is_flag()) {
    app.add_flag_callback(option.names, [&, command] { give(program, command, option, ""); })
        ->disable_flag_override();  // refuses "--waters=no", which would set the flag
    return;
  }
  CLI::Option* const added =
      app.add_option(option.names, CLI::callback_t([&, command](const CLI::results_t& results) {
                       for (const std::string& text : results) give(program, command, option, text);
                       return true;
                     }));
  // An option takes one word at a time. Otherwise "--chain A FILE" would take the file, too.
  if (option.list) added->expected(1, CLI::detail::expected_max_vector_size);
  added->allow_extra_args(option.list && option.is_argument())->required(option.required);
  if (option.list) added->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

const Option* find(const std::vector<Option>& options, const std::string& name) {
  for (const Option& option : options) {
    for (const std::string& known : option.all_names()) {
      if (known == name) return &option;
    }
  }
  return nullptr;
}

// Returns a complaint if an option such as "--json=" has no value, because CLI11 would take the
// next word for it. Empty: no such option.
std::string nothing_behind_equals(const OptionProgram& program,
                                  const std::vector<std::string>& words) {
  const std::vector<Option>* options = &program.options;
  for (std::size_t k = 0; k < words.size() && words[k] != "--"; ++k) {
    if (const OptionCommand* const command = program.find(words[k]);
        command != nullptr && options == &program.options) {
      options = &command->options;
    }
    if (!words[k].starts_with("--") || words[k].find('=') + 1 != words[k].size()) continue;
    const Option* const option = find(*options, words[k].substr(0, words[k].size() - 1));
    if (option == nullptr) continue;
    if (option->is_flag()) return option->shown_name() + " takes no value";
    if (!option->may_be_empty) return option->shown_name() + ": " + empty_value(*option, 1);
    return option->shown_name() + " has no value; write an empty value as " + option->shown_name() +
           " ''";
  }
  return {};
}

// Returns a complaint about an unknown command or option. It is the cause of any other error of the
// parser. Empty: all are known.
std::string unknown_word(const OptionProgram& program, const std::vector<std::string>& words) {
  const OptionCommand* command = nullptr;
  const std::vector<Option>* options = &program.options;
  for (std::size_t k = 0; k < words.size() && words[k] != "--"; ++k) {
    const std::string name = words[k].substr(0, words[k].find('='));
    if (name.size() < 2 || name.front() != '-') {
      if (command != nullptr || program.commands.empty()) continue;
      command = program.find(name);
      if (command == nullptr) {
        return "there is no command \"" + name + "\"." +
               did_you_mean(name, program.command_names());
      }
      options = &command->options;
      continue;
    }
    if (name.starts_with("--") || find(*options, name.substr(0, 2)) == nullptr) {
      const Option* const found = find(*options, name);
      if (found == nullptr) {
        return "there is no option " + name + "." + did_you_mean(name, dashed_names(*options));
      }
      if (!found->is_flag() && name.size() == words[k].size()) ++k;
    } else if (name.size() == 2 && !find(*options, name)->is_flag()) {
      ++k;
    }
  }
  return {};
}

// The words in CLI11's order, the last one first.
std::vector<std::string> words_for_cli11(const std::vector<std::string>& words) {
  std::vector<std::string> marked;
  bool behind = false;
  for (const std::string& word : words) {
    if (behind) {
      marked.push_back(kBehindDashes + word);
    } else if (word == "--") {
      behind = true;
    } else {
      marked.push_back(word);
    }
  }
  std::reverse(marked.begin(), marked.end());
  return marked;
}

// Returns an error of CLI11 in the words of this program.
std::string in_words(const OptionProgram& program, const OptionCommand* command,
                     const CLI::ParseError& error) {
  std::string said = error.what();
  const std::string name = said.substr(0, said.find(':'));
  if (command == nullptr && !program.commands.empty()) {
    std::string known;
    for (const std::string& c : program.command_names()) known += (known.empty() ? "" : ", ") + c;
    return "name a command: " + known;
  }
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
    std::string text = "too many arguments" + said.substr(std::min(said.find(": "), said.size()));
    std::erase(text, kBehindDashes);
    return text;
  }
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) == nullptr) return said;
  if (said.ends_with("disallowed flag override")) {
    return "--" + said.substr(0, said.find(' ')) + " takes no value";
  }
  return name + (said.ends_with("missing") ? " needs a value" : " can be given only once");
}

ParsedArguments failure(const OptionProgram& program, const OptionCommand* command,
                        std::string reason) {
  if (reason.back() != '.' && reason.back() != '?') reason += '.';
  return {command, true, program.usage_exit_code,
          program.name + ": " + reason + "\nUsage: " + usage_line(program, command) + "\nSee " +
              program.name + (command ? " " + command->name : "") + " --help\n"};
}

const OptionCommand* named_command(const OptionProgram& program,
                                   const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    if (const OptionCommand* const found = program.find(word)) return found;
  }
  return nullptr;
}

}  // namespace

ParsedArguments parse_arguments(const OptionProgram& program, int argc, const char* const* argv) {
  const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  CLI::App app;
  app.set_help_flag();
  for (const Option& option : program.options) add(app, program, nullptr, option);
  ParsedArguments parsed;
  for (const OptionCommand& command : program.commands) {
    CLI::App* const sub = app.add_subcommand(command.name);
    sub->set_help_flag();
    // CLI11 takes long to add options, so commands that are not named get none.
    const bool named = std::find(words.begin(), words.end(), command.name) != words.end();
    for (const Option& option : command.options) {
      if (named) add(*sub, program, &command, option);
    }
    sub->callback([&] {
      parsed.command = &command;
      if (command.answer == InsteadOfRunning::help) throw Answered{help_text(program, nullptr)};
      if (command.check) command.check();
    });
  }
  if (!program.commands.empty()) app.require_subcommand(1);
  if (const std::string nothing = nothing_behind_equals(program, words); !nothing.empty()) {
    return failure(program, named_command(program, words), nothing);
  }
  try {
    app.parse(words_for_cli11(words));
  } catch (const Answered& answered) {
    parsed.ended = true;
    parsed.text = answered.text;
  } catch (const CLI::ParseError& error) {
    const std::string unknown = unknown_word(program, words);
    const OptionCommand* const command = named_command(program, words);
    return failure(program, command, unknown.empty() ? in_words(program, command, error) : unknown);
  } catch (const std::invalid_argument& error) {
    return failure(program, named_command(program, words), error.what());
  }
  return parsed;
}

}  // namespace alphascope
