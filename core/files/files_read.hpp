// SPDX-License-Identifier: GPL-3.0-or-later
// The files that this process has read, under all of their names. No output may replace them.
// RegularFile adds files to the list, and AtomicFile checks it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace alphascope {

// The kind of a file that is read or written. A session may replace a session that was read, and
// preferences may replace preferences. Nothing else replaces a file that was read.
enum class FileKind : std::uint8_t { other, session, preferences };

// Adds the file of an open descriptor, unless it is a pipe or device.
void note_read(int descriptor, const std::filesystem::path& name, FileKind kind = FileKind::other);
// Adds a file that will be read; does nothing if it does not exist.
void note_read(const std::filesystem::path& file, FileKind kind = FileKind::other);

// The name of the file that was read and that this output would replace, or that the descriptor
// writes to. Empty if no such file was read.
std::optional<std::string> input_replaced_by(const std::filesystem::path& output,
                                             FileKind kind = FileKind::other);
std::optional<std::string> input_replaced_by(int descriptor);

}  // namespace alphascope
