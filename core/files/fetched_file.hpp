// SPDX-License-Identifier: GPL-3.0-or-later
// The folder of fetched files. The path of a file in it names the file's address, so that every
// reader knows where a molecule came from.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace alphascope {

// $XDG_CACHE_HOME/alphascope, or ~/.cache/alphascope. Empty if there is no home.
std::filesystem::path fetched_files_folder();

// The place of a file in that folder: FOLDER/https/files.rcsb.org/download/1CRN.cif.gz. The address
// begins with https:// or http:// and has no "." and ".." between its slashes.
std::filesystem::path fetched_file_path(const std::filesystem::path& folder,
                                        std::string_view address);

struct FetchedFrom {
  std::string address;
  std::string time;  // when it was fetched, in UTC: "2026-11-27T20:31:05Z"

  std::string text() const { return address + " at " + time; }
};

// Where and when the file was fetched. Empty for a file outside the folder of fetched files.
std::optional<FetchedFrom> fetched_from(
    const std::filesystem::path& file,
    const std::filesystem::path& folder = fetched_files_folder());

}  // namespace alphascope
