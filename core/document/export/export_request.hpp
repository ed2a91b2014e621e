// SPDX-License-Identifier: GPL-3.0-or-later
// A request to export the complex on screen.
#pragma once

#include <cstdint>
#include <filesystem>

namespace alphascope {

// Colours of the boundary's vertices; `solid` gives each solid one colour.
enum class ExportColours : std::uint8_t { element, chain, solid };

// A request to export the complex on screen.
struct ExportRequest {
  std::filesystem::path path;  // its ending determines the format
  ExportColours colours = ExportColours::element;
};

}  // namespace alphascope
