// Telling the formats of coordinate files apart, by content first and by extension second.
#pragma once

#include <filesystem>
#include <optional>
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
  charmm_card,
  pdbqt
};

// "pdb", "mmcif", "pqr", "xyz", "tinker", "xyzr" (all tables of balls), "charmm", "pdbqt".
std::optional<FileFormat> format_from_id(std::string_view id);
std::string_view format_id(FileFormat format);  // "" for unknown

// unknown for what is certainly something else (core/read/lookalike.hpp), whatever its name.
FileFormat sniff_format(const std::filesystem::path& path, std::string_view text);

}  // namespace alphascope
