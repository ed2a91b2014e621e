// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a file in pieces and hashes them.
#include "core/files/file_hash.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <vector>

#include "core/files/read_error.hpp"
#include "core/files/regular_file.hpp"
#include "core/files/sha256.hpp"

namespace alphascope {

std::string hash_of_file(const std::filesystem::path& path, const RunContext& context) {
  constexpr std::size_t kChunk = std::size_t{1} << 18;
  const RegularFile file(path);
  std::vector<char> chunk(kChunk);
  Sha256 hash;
  for (;;) {
    context.cancel.throw_if_cancelled();
    const ssize_t got = ::read(file.descriptor(), chunk.data(), chunk.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) {
      throw ReadError(path, 0, std::string("reading stopped: ") + std::strerror(errno),
                      "Check the disk or the network drive");
    }
    if (got == 0) return hash.finish();
    hash.update({chunk.data(), static_cast<std::size_t>(got)});
  }
}

}  // namespace alphascope
