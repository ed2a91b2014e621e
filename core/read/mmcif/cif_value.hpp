// SPDX-License-Identifier: GPL-3.0-or-later
// A raw value of a CIF file, and its meaning.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

#include "core/read/decimal.hpp"

namespace alphascope {

struct CifValue {
  std::string_view raw;  // with quotes
  std::size_t line = 0;
};

// The text without its quotes. Empty for the unknown value "?" and the inapplicable value ".".
std::string_view plain_cif(std::string_view raw);

// An atom's x, y or z in Å. A standard uncertainty behind it, as in 12.345(6), is dropped. Throws
// ReadError with file and line.
Decimal cif_coordinate(const std::filesystem::path& file, const CifValue& value, char axis);

}  // namespace alphascope
