// What writes files of a result, as a derived result: for formats that are no text, or more files
// than one.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "core/files/atomic_file.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

struct FileWriter {
  // To `files`, which are open, the first at `path`. In the caller's task arena. Does not commit.
  // Throws WriteError, Cancelled, and std::invalid_argument, a sentence, for what cannot be written
  // so.
  std::function<void(const std::filesystem::path& path, const std::vector<AtomicFile*>& files,
                     const RunContext& context)>
      write;
};

}  // namespace alphascope
