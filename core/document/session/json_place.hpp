// Where in a JSON text a value stands, for messages; what parses JSON forgets it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace alphascope {

// From the outermost object inwards: names of members, and places in arrays as numbers from 0.
using JsonPlace = std::vector<std::string>;

std::string place_text(const JsonPlace& place);  // "display.beside.ligands"

// The line, from 1, on which the value begins. `json` is valid JSON that has such a place.
std::size_t line_of(std::string_view json, const JsonPlace& place);
std::size_t line_at(std::string_view text, std::size_t offset);

// How many arrays and objects stand inside each other, at most; stops counting beyond `limit`.
// `offset` is where the limit is passed. Also of text that is no JSON.
bool nested_deeper_than(std::string_view json, std::size_t limit, std::size_t& offset);

}  // namespace alphascope
