// What the fields of a line are, for telling formats of plain columns apart.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace alphascope {

// Of the first eight fields: 'i' integer, 'n' other number, 'w' word.
std::string field_kinds(std::string_view line);

// Are there `count` numbers from field k on?
bool are_numbers_from(std::string_view kinds, std::size_t k, std::size_t count);

}  // namespace alphascope
