// SPDX-License-Identifier: GPL-3.0-or-later
// The exception of all readers: the file, the line, the fault and the remedy.
#pragma once

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "core/text/printable.hpp"

namespace alphascope {

// what() is a complete printable sentence: "FILE, line N: reason. Remedy."
class ReadError : public std::runtime_error {
 public:
  // line counts from 1; 0: the fault is in no line. reason and remedy have no full stop.
  ReadError(std::filesystem::path file, std::size_t line, std::string reason, std::string remedy)
      : std::runtime_error(sentence(file, line, reason, remedy)),
        file_(std::move(file)),
        line_(line),
        reason_(printable(reason)),
        remedy_(std::move(remedy)) {}

  const std::filesystem::path& file() const { return file_; }
  std::size_t line() const { return line_; }
  const std::string& reason() const { return reason_; }
  const std::string& remedy() const { return remedy_; }

 private:
  static std::string sentence(const std::filesystem::path& file, std::size_t line,
                              const std::string& reason, const std::string& remedy) {
    std::string text = file.string();
    if (line > 0) text += ", line " + std::to_string(line);
    text += ": " + reason + ".";
    if (!remedy.empty()) text += " " + remedy + ".";
    return printable(text);
  }

  std::filesystem::path file_;
  std::size_t line_;
  std::string reason_, remedy_;
};

}  // namespace alphascope
