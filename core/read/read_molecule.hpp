// SPDX-License-Identifier: GPL-3.0-or-later
// Opens a molecule from a file of any known format, plain or packed with gzip.
#pragma once

#include <filesystem>

#include "core/files/read_error.hpp"
#include "core/files/read_options.hpp"
#include "core/molecule/molecule.hpp"
#include "core/read/file_format.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// Throws ReadError with a sentence for people, and Cancelled.
Molecule read_molecule(const std::filesystem::path& path, const ReadOptions& options = {},
                       const RunContext& context = {});

// Reads a loaded text with the format's own reader. For a null format or a blank text, the error
// says what the text looks like.
Molecule read_format(const FileFormat* format, const ReaderInput& input);

}  // namespace alphascope
