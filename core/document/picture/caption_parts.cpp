// SPDX-License-Identifier: GPL-3.0-or-later
// The table of caption parts, and reading and writing of choices.
#include "core/document/picture/caption_parts.hpp"

#include <algorithm>
#include <stdexcept>

#include "core/text/text_parts.hpp"

namespace alphascope {
namespace {

constexpr CaptionPartInfo kParts[] = {{CaptionPart::file, "file", "File"},
                                      {CaptionPart::alpha, "alpha", "Alpha"},
                                      {CaptionPart::solvent, "solvent", "Solvent radius"},
                                      {CaptionPart::radii, "radii", "Radii set"},
                                      {CaptionPart::counts, "counts", "Simplices"},
                                      {CaptionPart::engine, "engine", "Engine"},
                                      {CaptionPart::hash, "hash", "Hash"}};

}  // namespace

std::span<const CaptionPartInfo> caption_parts() {
  return kParts;
}

CaptionParts usual_caption() {
  CaptionParts parts;
  for (const CaptionPart part :
       {CaptionPart::file, CaptionPart::alpha, CaptionPart::solvent, CaptionPart::counts}) {
    parts.set(part, true);
  }
  return parts;
}

CaptionParts read_caption_parts(const std::string& text) {
  CaptionParts parts;
  if (text == "none") return parts;
  if (text == "usual") return usual_caption();
  if (text == "all") {
    for (const CaptionPartInfo& info : kParts) parts.set(info.part, true);
    return parts;
  }
  for (const std::string& word : parts_of(text, ',')) {
    const auto info = std::find_if(std::begin(kParts), std::end(kParts),
                                   [&](const CaptionPartInfo& p) { return word == p.id; });
    if (info == std::end(kParts)) {
      throw std::invalid_argument("\"" + word +
                                  "\" is not a part of a caption; use usual, all, none, " +
                                  "or some of " + caption_part_ids() + " with commas between");
    }
    parts.set(info->part, true);
  }
  if (!parts.any())
    throw std::invalid_argument("no part of a caption is named; use none for no caption");
  return parts;
}

std::string caption_parts_text(CaptionParts parts) {
  std::string text;
  for (const CaptionPartInfo& info : kParts) {
    if (parts.has(info.part)) text += (text.empty() ? "" : ",") + std::string(info.id);
  }
  return text.empty() ? "none" : text;
}

std::string caption_part_ids() {
  std::string text;
  for (const CaptionPartInfo& info : kParts)
    text += (text.empty() ? "" : ", ") + std::string(info.id);
  return text;
}

}  // namespace alphascope
