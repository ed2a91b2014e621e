// The formats of coordinate files: each is one entry, made beside its reader, and file_formats.cpp
// lists it. Nothing else lists formats.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/molecule/molecule.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

struct ReaderInput {
  std::filesystem::path source;  // for messages and Molecule::source only
  std::string_view text;
  RunContext context;

  // To be called now and then while reading: reports the share done, and throws Cancelled.
  void report(std::size_t bytes_left) const {
    context.cancel.throw_if_cancelled();
    context.report("reading",
                   1 - static_cast<double>(bytes_left) / static_cast<double>(text.size()));
  }
};

// A text by which formats recognise themselves.
struct FileSample {
  std::string_view text;
  std::string ending = {};  // of the file's name, in small letters, without .gz: ".pdb"
  // The first line that is neither blank, nor a comment with #, nor a REMARK; and two behind it.
  std::string_view first = {}, second = {}, third = {};
  std::string_view before = {};  // what stands above `first`
};

// How well a text fits a format. Of several that fit as well, the first of the list is taken.
enum class Recognised : std::uint8_t {
  no,
  by_ending,  // if the name ends so: damaged files are best described by their own reader
  likely,
  certain  // by something that no other format has
};

struct FileFormat {
  std::string_view id;                    // of options and session files: "pdb"
  std::string_view name;                  // for people: "PDB"
  std::vector<std::string_view> endings;  // ".pdb"; the file dialog lists such files
  Recognised (*recognise)(const FileSample& sample);
  // Text in, molecule out. Throws ReadError with the line at fault, and Cancelled.
  Molecule (*read)(const ReaderInput& input);
  // Its columns tell where a cut goes through the last line's numbers; else a note says that they
  // may be wrong.
  bool tells_cuts = false;
};

const std::vector<FileFormat>& file_formats();
const FileFormat* format_from_id(std::string_view id);  // null: there is none

// By content first and by ending second. Null where it is none, and for what is certainly something
// else (core/read/lookalike.hpp), whatever its name.
const FileFormat* recognise_format(const std::filesystem::path& path, std::string_view text);

// Does the name end as that of some format, packed with gzip or not?
bool has_molecule_ending(const std::filesystem::path& path);

std::string format_ids();    // "pdb|pdbqt|…"
std::string format_names();  // "PDB, PDBQT, …"

}  // namespace alphascope
