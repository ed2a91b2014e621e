// SPDX-License-Identifier: GPL-3.0-or-later
// Reads and writes colours as text.
#include "core/chart/colour_text.hpp"

#include <charconv>
#include <cstdio>

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/name_table.hpp"
#include "core/molecule/rgb8.hpp"

namespace alphascope {

std::string colour_text(const Rgb8& colour) {
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", colour.r, colour.g, colour.b);
  return text;
}

std::optional<Rgb8> read_colour(std::string_view text) {
  if (text.starts_with('#')) text.remove_prefix(1);
  const std::size_t digits = text.size() / 3;  // digits of each component
  if (text.size() != 3 && text.size() != 6) return std::nullopt;
  std::uint8_t parts[3];
  for (std::size_t k = 0; k < 3; ++k) {
    unsigned value = 0;
    const char* const begin = text.data() + k * digits;
    const auto read = std::from_chars(begin, begin + digits, value, 16);
    if (read.ec != std::errc() || read.ptr != begin + digits) return std::nullopt;
    parts[k] = static_cast<std::uint8_t>(digits == 1 ? 17 * value : value);
  }
  return Rgb8{parts[0], parts[1], parts[2]};
}

}  // namespace alphascope
