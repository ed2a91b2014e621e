// Opening a molecule from a file of any format that we know, plain or packed with gzip.
#pragma once

#include <cstdint>
#include <filesystem>

#include "core/io/read_error.hpp"
#include "core/molecule/molecule.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

struct ReadOptions {
  // Most text to accept, after unpacking (bytes): a small gzip file can unpack to terabytes.
  std::uint64_t max_bytes = std::uint64_t{4} << 30;
};

// Formats: PDB and mmCIF; XYZR and the two x-y-z-r dialects of CRD. Told apart by content and by
// extension. Throws ReadError with a sentence for people, and Cancelled.
Molecule read_molecule(const std::filesystem::path& path, const ReadOptions& options = {},
                       const RunContext& context = {});

}  // namespace alphascope
