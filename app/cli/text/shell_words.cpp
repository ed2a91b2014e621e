// SPDX-License-Identifier: GPL-3.0-or-later
// Quotes arguments for a shell.
#include "app/cli/text/shell_words.hpp"

#include "core/text/printable.hpp"

namespace alphascope::cli {
namespace {

bool is_plain(const std::string& word) {
  constexpr const char* kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_./,=:+%@";
  return !word.empty() && word.find_first_not_of(kPlain) == std::string::npos;
}

std::string quoted(const std::string& word) {
  if (is_plain(word)) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

}  // namespace

std::string command_text(const std::vector<std::string>& arguments, bool threads) {
  std::string text = "alphascope-cli";
  for (std::size_t k = 1; k < arguments.size(); ++k) {
    const std::string& argument = arguments[k];
    const bool of_threads = !threads && argument == "--threads";
    const bool separate = argument == "-o" || argument == "--output" || of_threads;
    if (separate) ++k;  // skips the option's value
    if (separate || argument.starts_with("-o") || argument.starts_with("--output=")) continue;
    if (!threads && argument.starts_with("--threads=")) continue;
    text += " " + quoted(argument);
  }
  return printable(text);
}

}  // namespace alphascope::cli
