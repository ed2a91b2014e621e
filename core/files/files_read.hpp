// What is read is never written: the files that this process has read, under all of their names,
// which no output replaces. RegularFile notes them, AtomicFile asks.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace alphascope {

// What a file is read as, and what an output is. A session may replace a session that was read, and
// preferences those; nothing else replaces what was read.
enum class FileKind : std::uint8_t { other, session, preferences };

// The file behind an open descriptor. What is no ordinary file is not noted.
void note_read(int descriptor, const std::filesystem::path& name, FileKind kind = FileKind::other);
// A file that is going to be read; nothing when it is not there.
void note_read(const std::filesystem::path& file, FileKind kind = FileKind::other);

// The name by which the file was read that an output of this kind would replace, or that the
// descriptor writes to; none: no such file was read.
std::optional<std::string> read_behind(const std::filesystem::path& output,
                                       FileKind kind = FileKind::other);
std::optional<std::string> read_behind(int descriptor);

}  // namespace alphascope
