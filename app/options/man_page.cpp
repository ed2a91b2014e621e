// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the manual page in roff.
#include "app/options/man_page.hpp"

#include <cctype>

#include "app/options/help_text.hpp"
#include "core/text/text_parts.hpp"

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
        result += "\\-";  // a minus sign, which can be copied into a shell, not a hyphen
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

constexpr std::size_t kLineBytes = 80;  // more is bad style in a page's source

// Bytes of a text in the source that roff sees, with \[u00C5] for Å.
std::size_t source_bytes(const std::string& text) {
  std::size_t bytes = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) ++bytes;
    if (byte >= 0xC0) bytes += 8;
  }
  return bytes;
}

// Divides an escaped text into lines, at blanks. `end` stands at the end of all lines but the last.
std::string wrapped(const std::string& text, const std::string& end = "") {
  std::string lines, line;
  bool begun = false;
  for (const std::string& word : parts_of(text, ' ')) {
    if (begun && source_bytes(line + " " + word + end) > kLineBytes) {
      lines += line + end + "\n";
      // The next line must not begin as a command of roff.
      line = (word.starts_with('.') ? "\\&" : "") + word;
    } else {
      line += (begun ? " " : "") + word;
    }
    begun = true;
  }
  return lines + line;
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
  return ".TP\n" + head + "\n" + wrapped(escaped(text) + ".") + "\n";
}

std::string entries(const std::string& heading, const std::vector<ManualEntry>& entries) {
  if (entries.empty()) return {};
  std::string text = section(heading);
  for (const ManualEntry& entry : entries) {
    text +=
        ".TP\n\\fB" + escaped(entry.name) + "\\fR\n" + wrapped(escaped(entry.text) + ".") + "\n";
  }
  return text;
}

// "alphascope(1)", with a bold name.
std::string see_also(const std::vector<std::string>& pages) {
  if (pages.empty()) return {};
  std::string text = section("See also");
  for (const std::string& page : pages) {
    const std::size_t end = page.find('(');
    text += ".BR " + escaped(page.substr(0, end)) + " " + page.substr(end) +
            (&page == &pages.back() ? "\n" : " ,\n");
  }
  return text;
}

std::string entries(const std::vector<Option>& options) {
  std::string text;
  for (const Option& option : options) text += entry(option);
  return text;
}

}  // namespace

std::string man_page(const OptionProgram& program) {
  std::string text = ".\\\" -*- coding: utf-8 -*-\n.TH " + escaped(upper(program.name)) + " 1 \"" +
                     program.date + "\" \"" + escaped(program.name + " " + program.version) +
                     "\"\n";
  text += ".ad l\n";  // left-aligned, without stretched blanks
  text += section("Name") + wrapped(escaped(program.name) + " \\- " + escaped(program.text)) + "\n";
  text += section("Synopsis");
  if (program.commands.empty()) text += escaped(usage_line(program, nullptr)) + "\n";
  for (const OptionCommand& command : program.commands) {
    text += (&command == &program.commands.front() ? "" : ".br\n") +
            escaped(usage_line(program, &command)) + "\n";
  }
  text += section("Options") + entries(program.options);
  if (!program.commands.empty()) text += section("Commands");
  for (const OptionCommand& command : program.commands) {
    text += ".SS " + escaped(program.name + " " + command.name) + "\n" +
            wrapped(escaped(command.text) + ".") + "\n" + entries(command.options);
  }
  for (const OptionNotes& notes : program.notes) {
    text += section(notes.heading) + ".nf\n";
    for (const std::string& line : notes.lines) text += wrapped(escaped(line), " \\") + "\n";
    text += ".fi\n";
  }
  text += entries("Environment", program.environment) + entries("Files", program.files);
  text += see_also(program.see_also);
  return text;
}

}  // namespace alphascope
