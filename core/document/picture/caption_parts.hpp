// SPDX-License-Identifier: GPL-3.0-or-later
// Choice of the parts of a picture's caption, by names. ui/caption.hpp makes their texts.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace alphascope {

enum class CaptionPart : std::uint8_t { file, alpha, solvent, radii, counts, engine, hash };

struct CaptionPartInfo {
  CaptionPart part;
  const char* id;     // as typed
  const char* title;  // as shown
};
std::span<const CaptionPartInfo> caption_parts();

class CaptionParts {
 public:
  bool has(CaptionPart part) const { return (bits_ & bit(part)) != 0; }
  void set(CaptionPart part, bool wanted) {
    bits_ = static_cast<std::uint8_t>(wanted ? bits_ | bit(part) : bits_ & ~bit(part));
  }
  bool any() const { return bits_ != 0; }
  friend bool operator==(const CaptionParts&, const CaptionParts&) = default;

 private:
  static constexpr unsigned bit(CaptionPart part) { return 1u << static_cast<unsigned>(part); }
  std::uint8_t bits_ = 0;
};

// File, alpha, solvent radius (if there is one) and counts.
CaptionParts usual_caption();

// Reads "usual", "all", "none", or ids with commas between: "alpha,counts". Throws
// std::invalid_argument with a clause that lists the ids.
CaptionParts read_caption_parts(const std::string& text);
// The ids with commas between, or "none".
std::string caption_parts_text(CaptionParts parts);
std::string caption_part_ids();  // "file, alpha, …"

}  // namespace alphascope
