// SPDX-License-Identifier: GPL-3.0-or-later
// Colours as text, such as "#5aa9e6".
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/molecule/atom_colours.hpp"

namespace alphascope {

std::string colour_text(const Rgb8& colour);  // "#5aa9e6"
// Reads "#5aa9e6", "5AA9E6" or "#5ae". Returns nothing for any other text.
std::optional<Rgb8> read_colour(std::string_view text);

}  // namespace alphascope
