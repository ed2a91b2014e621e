// SPDX-License-Identifier: GPL-3.0-or-later
// The table of AutoDock's atom types.
#include "core/read/residues/autodock_types.hpp"

#include <algorithm>
#include <iterator>

namespace alphascope {
namespace {

constexpr Element kCarbon = 6, kNitrogen = 7, kOxygen = 8, kSulphur = 16;

// AutoDock 4.2's table and Meeko's additions. A type that is missing here is an element's symbol.
constexpr struct {
  std::string_view type;
  Element element;
} kTypes[] = {{"HD", kHydrogen}, {"HS", kHydrogen}, {"HC", kHydrogen}, {"A", kCarbon},
              {"G", kCarbon},    {"GA", kCarbon},   {"J", kCarbon},    {"Q", kCarbon},
              {"CG", kCarbon},   {"CX", kCarbon},   {"N", kNitrogen},  {"NA", kNitrogen},
              {"NS", kNitrogen}, {"NX", kNitrogen}, {"O", kOxygen},    {"OA", kOxygen},
              {"OS", kOxygen},   {"OX", kOxygen},   {"SA", kSulphur}};

bool is_numbered(std::string_view type, std::string_view word) {
  return type.size() > word.size() && type.starts_with(word) &&
         std::all_of(type.begin() + static_cast<std::ptrdiff_t>(word.size()), type.end(),
                     [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

StatedElement autodock_element(std::string_view type) {
  const auto* found = std::find_if(std::begin(kTypes), std::end(kTypes),
                                   [&](const auto& known) { return known.type == type; });
  if (found != std::end(kTypes)) return {ElementStatement::element, found->element};
  // In an opened ring each end has a carbon CG0, and a point G0 where the other end should be.
  if (is_numbered(type, "CG")) return {ElementStatement::element, kCarbon};
  if (is_numbered(type, "G") || type == "TZ" || type == "W") {
    return {ElementStatement::virtual_site, kUnknownElement};
  }
  return stated_element(type);
}

}  // namespace alphascope
