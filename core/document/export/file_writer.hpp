// SPDX-License-Identifier: GPL-3.0-or-later
// A function that writes files of a result, as a derived result. It is for formats that are not
// text or need several files.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

namespace alphascope {

class AtomicFile;
struct RunContext;

struct FileWriter {
  // Writes to `files`, which must be open; the first is the one at `path`. Uses the caller's task
  // arena. Does not commit. Throws WriteError, Cancelled, and std::invalid_argument with a sentence
  // if the format cannot hold the result.
  std::function<void(const std::filesystem::path& path, const std::vector<AtomicFile*>& files,
                     const RunContext& context)>
      write;
};

}  // namespace alphascope
