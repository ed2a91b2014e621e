// SPDX-License-Identifier: GPL-3.0-or-later
// Places of values in a JSON text, for messages; parsers do not keep them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace alphascope {

// Names of members and indices in arrays (from 0), from the outermost object inwards.
using JsonPlace = std::vector<std::string>;

std::string place_text(const JsonPlace& place);  // "display.beside.ligands"

// The line, from 1, on which the value begins. `json` must be valid and contain the place.
std::size_t line_of(std::string_view json, const JsonPlace& place);
std::size_t line_at(std::string_view text, std::size_t offset);

// Whether arrays and objects are nested deeper than `limit`. If so, `offset` is the position where
// the limit is exceeded. The text may be invalid JSON.
bool nested_deeper_than(std::string_view json, std::size_t limit, std::size_t& offset);

}  // namespace alphascope
