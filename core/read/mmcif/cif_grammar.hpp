// SPDX-License-Identifier: GPL-3.0-or-later
// The grammar of CIF as events in file order. Readers interpret the tables. Plain C++17, because
// gemmi's headers do not compile as C++20 with every compiler.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace alphascope {

// Tags and values are views of the text, with quotes. Lines count from 1.
class CifHandler {
 public:
  virtual ~CifHandler() = default;
  virtual void begin_block() = 0;
  virtual void begin_loop() = 0;
  virtual void loop_tag(std::string_view tag) = 0;
  virtual void loop_value(std::string_view raw, std::size_t line) = 0;
  virtual void end_loop() = 0;
  virtual void item_tag(std::string_view tag) = 0;
  virtual void item_value(std::string_view raw, std::size_t line) = 0;
};

class CifSyntaxError : public std::runtime_error {
 public:
  CifSyntaxError(std::size_t line, const std::string& what)
      : std::runtime_error(what), line_(line) {}
  std::size_t line() const { return line_; }

 private:
  std::size_t line_;
};

// Throws CifSyntaxError and any exception of the handler.
void parse_cif(std::string_view text, CifHandler& handler);

}  // namespace alphascope
