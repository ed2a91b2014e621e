// A value of a CIF file as its text has it, and what it means.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

#include "core/read/decimal.hpp"

namespace alphascope {

struct CifValue {
  std::string_view raw;  // quotes included
  std::size_t line = 0;
};

// The text without its quotes; empty for the unknown "?" and the inapplicable ".".
std::string_view plain_cif(std::string_view raw);

// An atom's x, y or z in Å; a standard uncertainty behind it, as in 12.345(6), is left out. Throws
// ReadError, with the file and the line.
Decimal cif_coordinate(const std::filesystem::path& file, const CifValue& value, char axis);

}  // namespace alphascope
