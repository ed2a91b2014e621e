// SPDX-License-Identifier: GPL-3.0-or-later
// Classifies the fields of a line as integers, other numbers and words.
#include "core/read/field_kinds.hpp"

#include "core/read/decimal.hpp"
#include "core/text_files/line_reader.hpp"

namespace alphascope {

std::string field_kinds(std::string_view line) {
  std::string kinds;
  for (std::string_view f = next_field(line); !f.empty() && kinds.size() < 8;
       f = next_field(line)) {
    Decimal value;
    if (parse_decimal(f, value) != DecimalStatus::ok) {
      kinds += 'w';
    } else {
      kinds += f.find_first_not_of("0123456789") == std::string_view::npos ? 'i' : 'n';
    }
  }
  return kinds;
}

bool are_numbers_from(std::string_view kinds, std::size_t k, std::size_t count) {
  if (kinds.size() < k + count) return false;
  return kinds.substr(k, count).find('w') == std::string_view::npos;
}

}  // namespace alphascope
