// What a file browser shows of a folder. Pure std::filesystem, no ImGui.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/run/cancel_token.hpp"

namespace alphascope {

struct FolderEntry {
  std::filesystem::path path;
  std::string name;
  bool folder = false;
  std::uintmax_t bytes = 0;
};

// What is to be listed.
struct FolderQuery {
  std::filesystem::path folder;
  bool all_files = false;    // also those that do not look like molecules, or like sessions
  bool hidden_ones = false;  // names that start with a dot
  bool sessions = false;     // files of sessions, not of molecules
  friend bool operator==(const FolderQuery&, const FolderQuery&) = default;
};

struct FolderListing {
  FolderQuery query;                 // of which this is the answer
  std::vector<FolderEntry> entries;  // folders first, then by name without regard to case
  std::size_t hidden_by_filter = 0;  // files that do not look like what is wanted
  std::string error;                 // why the folder cannot be read; empty otherwise
};

// .pdb .ent .cif .xyzr .pqr .xyz .crd, each also with .gz, in any case.
bool looks_like_molecule(const std::filesystem::path& path);

// Can take seconds for a large folder, or one on a slow disk. Throws Cancelled.
FolderListing list_folder(const FolderQuery& query, const CancelToken& cancel = {});

// The first entry whose name starts with `start`, without regard to case, counted from `from` and
// around the end; the number of entries when there is none.
std::size_t find_entry(const FolderListing& listing, std::string_view start, std::size_t from);

// Why a path that somebody typed cannot be opened: a sentence; empty when it can.
std::string why_not_openable(const std::filesystem::path& path);

// Several files dropped at once: the first that looks like a molecule is opened, else the first.
struct DroppedFiles {
  std::optional<std::filesystem::path> opened;
  std::string note;  // which file is opened and which are not, and why; empty for one file
};
DroppedFiles choose_dropped(const std::vector<std::filesystem::path>& files);

// "1.2 MB": one digit more than sizes of memory have.
std::string file_size_text(std::uintmax_t bytes);

// The present folder when it holds molecules, else the home folder, else "/".
std::filesystem::path sensible_start_folder();

}  // namespace alphascope
