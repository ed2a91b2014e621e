// SPDX-License-Identifier: GPL-3.0-or-later
// Shortens texts that are too long for their place. Pure text.
#pragma once

#include <functional>
#include <string>

namespace alphascope {

using TextWidth = std::function<float(const std::string&)>;

// Returns the text if it fits. Otherwise it keeps as much of beginning and end as fits, with "…"
// between.
std::string fitted_text(const std::string& text, float width, const TextWidth& width_of);

// Returns the text if it fits. Otherwise it keeps as much of the beginning as fits, with "…"
// behind.
std::string fitted_beginning(const std::string& text, float width, const TextWidth& width_of);

}  // namespace alphascope
