// SPDX-License-Identifier: GPL-3.0-or-later
// Escapes text so that it can stand in an XML file.
#pragma once

#include <string>
#include <string_view>

namespace alphascope {

// Replaces XML's reserved characters, and drops control characters that XML cannot express.
std::string xml_text(std::string_view text);

}  // namespace alphascope
