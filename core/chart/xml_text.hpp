// Text between the tags of an XML file.
#pragma once

#include <string>
#include <string_view>

namespace alphascope {

// With what XML reserves replaced, and without the control characters that it has no form for.
std::string xml_text(std::string_view text);

}  // namespace alphascope
