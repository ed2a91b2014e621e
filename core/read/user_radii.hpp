// Tables of radii that users write themselves.
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "core/files/read_error.hpp"
#include "core/radii/radii_set.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// One radius (Å, to 10^-6) per line, the first fitting rule of this order counts:
//   ALA CB 1.88    atom CB of residue ALA
//   *   CB 1.88    atom CB of any other residue
//   C      1.70    the element
// Text after # and blank lines are skipped. Throws ReadError for anything else, for a radius that
// is not above 0 and at most 60 Å or has more digits, and for an entry that is given twice.
std::shared_ptr<const UserRadii> read_user_radii(const std::filesystem::path& path,
                                                 const RunContext& context = {});

// The same from text in memory; `path` is for messages and UserRadii::source only.
UserRadii parse_user_radii(const std::filesystem::path& path, std::string_view text);

}  // namespace alphascope
