// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the scripts for bash, zsh and fish.
#include "app/options/completion.hpp"

namespace alphascope {
namespace {

template <class Words>
std::string joined(const Words& words, const char* between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

// Words that may stand where no option stands.
struct Arguments {
  bool files = false;
  std::vector<std::string> words;
};

Arguments arguments_of(const std::vector<Option>& options) {
  Arguments found;
  for (const Option& option : options) {
    if (!option.is_argument()) continue;
    found.files |= option.takes_file();
    for (std::string& word : option.choices()) found.words.push_back(std::move(word));
  }
  return found;
}

// The name of a shell function, such as "_alphascope_cli".
std::string function_name(const std::string& program) {
  std::string name = "_" + program;
  for (char& c : name) c = c == '-' ? '_' : c;
  return name;
}

// Writes a case for the value of each option, and one for words where no value is expected.
std::string bash_cases(const std::string& command, const std::vector<Option>& options) {
  std::string text;
  for (const Option& option : options) {
    if (option.is_argument() || option.is_flag()) continue;
    std::string patterns;
    for (const std::string& name : option.all_names()) {
      patterns += (patterns.empty() ? "\"" : "|\"") + command + " " + name + "\"";
    }
    text += "    " + patterns + ") words=\"" + joined(option.choices(), " ") +
            "\" files=" + (option.takes_file() ? "1" : "") + " ;;\n";
  }
  const Arguments bare = arguments_of(options);
  if (!bare.words.empty()) {
    return text + "    \"" + command + " \"*) words=\"" + joined(bare.words, " ") +
           "\" files= ;;\n";
  }
  return text + "    \"" + command + " \"*) words=\"" + joined(dashed_names(options), " ") +
         "\" files=" + (bare.files ? "1" : "") + " bare=1 ;;\n";
}

std::string bash(const OptionProgram& program) {
  const std::string function = function_name(program.name);
  std::string text = "# Completion of " + program.name +
                     " in bash, made from its table of options.\n" + function + R"sh(() {
  local current="${COMP_WORDS[COMP_CWORD]}" previous="" command="" words="" files="" bare="" k
  [ "$COMP_CWORD" -lt 1 ] || previous="${COMP_WORDS[COMP_CWORD-1]}"
  # bash takes the = of --option=value for a word of its own.
  if [ "$current" = "=" ]; then
    current=""
  elif [ "$previous" = "=" ]; then
    previous="${COMP_WORDS[COMP_CWORD-2]}"
  fi
  for ((k = 1; k < COMP_CWORD; ++k)); do
    case "${COMP_WORDS[k]}" in
      )sh" + (program.commands.empty() ? "-no-command-" : joined(program.command_names(), "|")) +
                     R"sh() command="${COMP_WORDS[k]}"; break ;;
    esac
  done
  case "$command $previous" in
)sh";
  for (const OptionCommand& command : program.commands) {
    text += bash_cases(command.name, command.options);
  }
  text += bash_cases("", program.options);
  text += R"sh(  esac
  if [ -n "$bare" ]; then
    case "$current" in
      -*) files="" ;;
      *) words="" ;;
    esac
    [ -n "$command" ] || [ -n "$words" ] || words=")sh" +
          joined(program.command_names(), " ") + R"sh("
  fi
  # The last of "A,B" is completed, what stands before it stays.
  local before=""
  case "$current" in
    *,*) [ -n "$bare" ] || { before="${current%,*},"; current="${current##*,}"; } ;;
  esac
  COMPREPLY=()
  while IFS= read -r k; do
    COMPREPLY+=("$before$k")
  done < <(compgen -W "$words" -- "$current"; [ -z "$files" ] || compgen -f -- "$current")
}
complete -o filenames -F )sh" +
          function + " " + program.name + "\n";
  return text;
}

// The text without characters that are special to zsh's _arguments or to fish.
std::string plain(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\'' || c == '[' || c == ']' || c == ':' || c == '\\' || c == '`' || c == '$') {
      result += ' ';
    } else {
      result += c == '"' ? '|' : c;
    }
  }
  return result;
}

std::string zsh_value(const Option& option) {
  if (option.is_flag()) return "";
  std::string action = " ";
  if (!option.choices().empty()) action = "(" + joined(option.choices(), " ") + ")";
  if (option.takes_file() && option.choices().empty()) action = "_files";
  return ":" + plain(option.value) + ":" + action;
}

std::string zsh_arguments(const std::vector<Option>& options, const std::string& indent) {
  std::string text;
  for (const Option& option : options) {
    if (option.is_argument()) continue;
    for (const std::string& name : option.all_names()) {
      text += " \\\n" + indent + "'" + (option.list ? "*" : "") + name + "[" + plain(option.text) +
              "]" + zsh_value(option) + "'";
    }
  }
  const Arguments bare = arguments_of(options);
  if (bare.files) text += " \\\n" + indent + "'*:FILE:_files'";
  if (!bare.words.empty()) {
    text += " \\\n" + indent + "':COMMAND:(" + joined(bare.words, " ") + ")'";
  }
  return text;
}

std::string zsh(const OptionProgram& program) {
  const std::string function = function_name(program.name);
  std::string text = "#compdef " + program.name +
                     "\n# Made from the program's table of options.\n" + function + "() {\n";
  if (program.commands.empty()) {
    text += "  _arguments -s" + zsh_arguments(program.options, "    ") + "\n";
  } else {
    text += "  local -a known\n  known=(\n";
    for (const OptionCommand& command : program.commands) {
      text += "    '" + command.name + ":" + plain(command.text) + "'\n";
    }
    text += "  )\n  if (( CURRENT == 2 )); then\n    _describe command known\n    _arguments -s" +
            zsh_arguments(program.options, "      ") +
            "\n    return\n  fi\n  local command=$words[2]\n  shift words\n  (( CURRENT-- ))\n"
            "  case $command in\n";
    for (const OptionCommand& command : program.commands) {
      text += "    " + command.name + ") _arguments -s" + zsh_arguments(command.options, "      ") +
              " ;;\n";
    }
    text += "  esac\n";
  }
  // zsh takes a file from its folder of completions as the function itself. If the file is sourced
  // instead, it must register the function.
  return text + "}\nif [ \"$funcstack[1]\" = \"_" + program.name + "\" ]; then\n  " + function +
         " \"$@\"\nelse\n  compdef " + function + " " + program.name + "\nfi\n";
}

std::string fish_options(const OptionProgram& program, const std::string& when,
                         const std::vector<Option>& options) {
  std::string text;
  const Arguments bare = arguments_of(options);
  if (!bare.words.empty()) {
    text += "complete -c " + program.name + when + " -f -a '" + joined(bare.words, " ") + "'\n";
  }
  for (const Option& option : options) {
    if (option.is_argument()) continue;
    std::string line = "complete -c " + program.name + when;
    for (const std::string& name : option.all_names()) {
      line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    }
    if (!option.is_flag()) line += option.takes_file() ? " -r -F" : " -x";
    if (!option.choices().empty()) line += " -a '" + joined(option.choices(), " ") + "'";
    text += line + " -d '" + plain(option.text) + "'\n";
  }
  return text;
}

std::string fish(const OptionProgram& program) {
  std::string text =
      "# Completion of " + program.name + " in fish, made from its table of options.\n";
  for (const OptionCommand& command : program.commands) {
    text += "complete -c " + program.name + " -n __fish_use_subcommand -f -a " + command.name +
            " -d '" + plain(command.text) + "'\n";
  }
  text += fish_options(program, program.commands.empty() ? "" : " -n __fish_use_subcommand",
                       program.options);
  for (const OptionCommand& command : program.commands) {
    text += fish_options(program, " -n '__fish_seen_subcommand_from " + command.name + "'",
                         command.options);
  }
  return text;
}

}  // namespace

std::string completion_script(const OptionProgram& program, const std::string& shell) {
  if (shell == "bash") return bash(program);
  if (shell == "zsh") return zsh(program);
  if (shell == "fish") return fish(program);
  return {};
}

}  // namespace alphascope
