// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of the fields of a line, by which formats of plain columns are told apart.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace alphascope {

// A letter for each of the first eight fields: 'i' integer, 'n' other number, 'w' word.
std::string field_kinds(std::string_view line);

// True when `count` numbers begin at field k.
bool are_numbers_from(std::string_view kinds, std::size_t k, std::size_t count);

}  // namespace alphascope
