// Telling the formats of coordinate files apart, by content first and by extension second.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace alphascope {

enum class FileFormat : unsigned char {
  unknown,
  pdb,
  mmcif,
  pqr,
  xyz,
  tinker_xyz,
  ball_table,
  charmm_card
};

FileFormat sniff_format(const std::filesystem::path& path, std::string_view text);

// What an unknown file looks like, to complete "it looks like …".
std::string describe_unknown(std::string_view text);

}  // namespace alphascope
