// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of radii that users write.
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "core/files/read_error.hpp"
#include "core/radii/radii_set.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// One radius per line (Å, up to six decimals). The first rule in this order that fits counts:
//   ALA CB 1.88    atom CB of residue ALA
//   *   CB 1.88    atom CB of any other residue
//   C      1.70    the element
// Text after # and blank lines are skipped. Throws ReadError for anything else and for an entry
// given twice. Throws it also for a radius with more digits, or outside 0 < radius <= 60 Å.
std::shared_ptr<const UserRadii> read_user_radii(const std::filesystem::path& path,
                                                 const RunContext& context = {});

// Parses a text in memory. `path` is only for messages and UserRadii::source.
UserRadii parse_user_radii(const std::filesystem::path& path, std::string_view text);

}  // namespace alphascope
