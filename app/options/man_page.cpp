// Writes the manual page in roff.
#include "app/options/man_page.hpp"

#include <cctype>

#include "app/options/help_text.hpp"

namespace alphascope {
namespace {

// Escapes a text, so that roff prints it unchanged.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '\\':
        result += "\\e";
        break;
      case '-':
        result += "\\-";  // a minus sign, which can be copied into a shell; not a hyphen
        break;
      case '\'':
        result += "\\(aq";
        break;
      case '^':
        result += "\\(ha";
        break;
      case '~':
        result += "\\(ti";
        break;
      case '`':
        result += "\\(ga";
        break;
      default:
        result += c;
    }
  }
  // A line that begins with a dot would be a roff command.
  return result.starts_with('.') ? "\\&" + result : result;
}

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

std::string section(const std::string& heading) {
  return ".SH " + escaped(upper(heading)) + "\n";
}

std::string entry(const Option& option) {
  std::string head;
  for (const std::string& name : option.all_names()) {
    head += (head.empty() ? "" : ", ") + ("\\fB" + escaped(name) + "\\fR");
  }
  if (option.is_argument()) {
    head = "\\fI" + escaped(option.names) + "\\fR" + (option.list ? "..." : "");
  } else if (!option.is_flag()) {
    head += " \\fI" + escaped(option.shown_value()) + "\\fR";
  }
  std::string text = option.text;
  if (option.required && !option.is_argument()) text += " (required)";
  if (!option.fallback.empty()) text += " (default: " + option.fallback + ")";
  return ".TP\n" + head + "\n" + escaped(text) + ".\n";
}

std::string entries(const std::vector<Option>& options) {
  std::string text;
  for (const Option& option : options) text += entry(option);
  return text;
}

}  // namespace

std::string man_page(const OptionProgram& program) {
  std::string text = ".\\\" -*- coding: utf-8 -*-\n.TH " + escaped(upper(program.name)) +
                     " 1 \"\" \"" + escaped(program.name + " " + program.version) + "\"\n";
  text += ".ad l\n";  // left-aligned, without stretched blanks
  text += section("Name") + escaped(program.name + " - " + program.text) + "\n";
  text += section("Synopsis");
  if (program.commands.empty()) text += escaped(usage_line(program, nullptr)) + "\n";
  for (const OptionCommand& command : program.commands) {
    text += escaped(usage_line(program, &command)) + "\n.br\n";
  }
  text += section("Options") + entries(program.options);
  if (!program.commands.empty()) text += section("Commands");
  for (const OptionCommand& command : program.commands) {
    text += ".SS " + escaped(program.name + " " + command.name) + "\n" + escaped(command.text) +
            ".\n" + entries(command.options);
  }
  for (const OptionNotes& notes : program.notes) {
    text += section(notes.heading) + ".nf\n";
    for (const std::string& line : notes.lines) text += escaped(line) + "\n";
    text += ".fi\n";
  }
  return text;
}

}  // namespace alphascope
