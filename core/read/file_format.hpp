// SPDX-License-Identifier: GPL-3.0-or-later
// The formats of coordinate files. Each is one entry, made beside its reader and listed in
// file_formats.cpp only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/run/cancel_token.hpp"

namespace alphascope {

struct Molecule;

struct ReaderInput {
  std::filesystem::path source;  // only for messages and Molecule::source
  std::string_view text;
  RunContext context;

  // Call it now and then while reading. It reports the share of the text that is read, and throws
  // Cancelled.
  void report(std::size_t bytes_left) const {
    context.cancel.throw_if_cancelled();
    context.report("reading",
                   1 - static_cast<double>(bytes_left) / static_cast<double>(text.size()));
  }
};

// A sample of a text, by which formats recognise it.
struct FileSample {
  std::string_view text;
  std::string ending = {};  // of the file name, in small letters, without .gz: ".pdb"
  // The first line that is neither blank, nor a comment with #, nor a REMARK, and the two lines
  // below it.
  std::string_view first = {}, second = {}, third = {};
  std::string_view before = {};  // the text above `first`
};

// How well a text fits a format. Among equals the first format of the list is taken.
enum class Recognised : std::uint8_t {
  no,
  by_ending,  // fits only if the file name has an ending of this format, whose reader describes
              // damaged files best
  likely,
  certain  // a mark that no other format has
};

struct FileFormat {
  std::string_view id;                    // "pdb": in options and session files
  std::string_view name;                  // "PDB": for people
  std::vector<std::string_view> endings;  // ".pdb": for the file dialog
  Recognised (*recognise)(const FileSample& sample);
  // Reads a molecule from a text. Throws ReadError with the line at fault, and Cancelled.
  Molecule (*read)(const ReaderInput& input);
  // True if the format's columns show when a file was cut off inside a number of its last line. For
  // other formats a note says that these numbers may be wrong.
  bool detects_truncation = false;
};

const std::vector<FileFormat>& file_formats();
const FileFormat* format_from_id(std::string_view id);  // null: no such format

// Recognises by content first, by ending second. Null for an unknown text. Null also for a text
// that is certainly something else (core/read/lookalike.hpp), whatever its name.
const FileFormat* recognise_format(const std::filesystem::path& path, std::string_view text);

// True for a name with the ending of some format, with or without .gz.
bool has_molecule_ending(const std::filesystem::path& path);

std::string format_ids();    // "pdb|pdbqt|…"
std::string format_names();  // "PDB, PDBQT, …"

}  // namespace alphascope
