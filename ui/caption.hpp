// What a caption says of a complex: in the window, over its picture, and in pictures that are
// saved. Numbers with their units and true minus signs. Pure text.
#pragma once

#include <string>
#include <vector>

#include "core/document/picture/caption_parts.hpp"
#include "core/document/store/answer.hpp"

namespace alphascope {

inline constexpr const char* kCaptionGap = "   ";  // between words on one line

// One entry for each part that there is: "1crn.pdb", "α = −0.25 Å²", "solvent 1.4 Å" (none without
// one), "radii: …", "327 vertices, 1,203 edges, …". `radii`: the name of the set.
std::vector<std::string> caption_words(const EngineAnswer& answer, const Molecule& molecule,
                                       const std::string& radii, CaptionParts parts);

}  // namespace alphascope
