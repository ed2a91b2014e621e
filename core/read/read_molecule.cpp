// SPDX-License-Identifier: GPL-3.0-or-later
// Loads a file, recognises its format, and reads and hashes it.
#include "core/read/read_molecule.hpp"

#include <future>

#include "core/geometry/lattice_alpha.hpp"
#include "core/read/lookalike.hpp"
#include "core/text_files/text_file.hpp"

namespace alphascope {
namespace {

constexpr std::size_t kHashInThreadFrom = std::size_t{1} << 20;  // bytes

void refuse_blank(const std::filesystem::path& path, std::string_view text) {
  if (text.find_first_not_of(" \t\r\n\v\f") != std::string_view::npos) return;
  throw ReadError(path, 0,
                  text.empty() ? "the file is empty: it holds no atoms"
                               : "the file has nothing but blanks: it holds no atoms",
                  "Fetch or copy it again");
}

}  // namespace

Molecule read_format(const FileFormat* format, const ReaderInput& input) {
  refuse_blank(input.source, input.text);
  if (format != nullptr) return format->read(input);
  const Lookalike found = find_lookalike(input.text);
  throw ReadError(input.source, 0,
                  "this is not a molecule file that can be read: it looks like " + found.what,
                  found.remedy.empty()
                      ? "Formats that can be opened: " + format_names() + ", also packed as .gz"
                      : found.remedy);
}

Molecule read_molecule(const std::filesystem::path& path, const ReadOptions& options,
                       const RunContext& context) {
  const LoadedText loaded = load_text(path, options.max_bytes, context, options.descriptor);
  // Hashing takes about as long as parsing, so large files are hashed on another thread.
  const bool large = loaded.text.size() > kHashInThreadFrom && !loaded.compressed;
  std::future<std::string> hash = std::async(large ? std::launch::async : std::launch::deferred,
                                             [&loaded] { return file_hash(loaded); });
  const FileFormat* const format =
      options.format != nullptr ? options.format : recognise_format(path, loaded.text);
  Molecule molecule = read_format(format, {path, loaded.text, context});
  molecule.sha256 = hash.get();
  if (!format->detects_truncation && loaded.text.back() != '\n') {
    molecule.notes.push_back(
        "The last line has no line end: if the file was cut off, its last atom may be wrong");
  }
  return molecule;
}

}  // namespace alphascope
