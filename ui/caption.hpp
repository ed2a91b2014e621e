// SPDX-License-Identifier: GPL-3.0-or-later
// Words of a caption, for the window and for saved pictures: facts of a complex, numbers with units
// and true minus signs. Pure text.
#pragma once

#include <string>
#include <vector>

namespace alphascope {

class CaptionParts;
struct EngineAnswer;
struct Molecule;

inline constexpr const char* kCaptionGap = "   ";  // between words on one line

// One entry for each part: "1crn.pdb", "α = −0.25 Å²", "solvent 1.4 Å" (if there is one), "radii:
// …", "327 vertices, 1,203 edges, …". `radii` is the name of the radii set; empty: no such part.
std::vector<std::string> caption_words(const EngineAnswer& answer, const Molecule& molecule,
                                       const std::string& radii, CaptionParts parts);

}  // namespace alphascope
