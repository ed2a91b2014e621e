// SPDX-License-Identifier: GPL-3.0-or-later
// Tests molecules from an open descriptor, and of a named format.
#include <gtest/gtest.h>
#include <unistd.h>

#include <thread>

#include "core/read/read_molecule.hpp"

namespace alphascope {
namespace {

// Reads from a pipe into which the pieces are written one by one.
Molecule read_piped(const std::vector<std::string>& pieces, ReadOptions options = {}) {
  int ends[2];
  if (::pipe(ends) != 0) throw std::runtime_error("pipe");
  std::thread writer([&] {
    for (const std::string& piece : pieces) {
      EXPECT_EQ(::write(ends[1], piece.data(), piece.size()), static_cast<ssize_t>(piece.size()));
    }
    ::close(ends[1]);
  });
  options.descriptor = ends[0];
  try {
    Molecule molecule = read_molecule("stdin", options);
    writer.join();
    ::close(ends[0]);
    return molecule;
  } catch (...) {
    writer.join();
    ::close(ends[0]);
    throw;
  }
}

TEST(ReadDescriptor, ReadsAPipeToItsEnd) {
  std::vector<std::string> pieces;
  for (int n = 0; n < 1000; ++n) pieces.push_back(std::to_string(n) + " 0 0");
  for (std::string& piece : pieces) piece += " 1.5\n";
  const Molecule molecule = read_piped(pieces);
  EXPECT_EQ(molecule.atoms.size(), 1000u);
  EXPECT_EQ(molecule.source, "stdin");
  EXPECT_EQ(molecule.sha256.size(), 64u);
}

TEST(ReadDescriptor, KeepsTheLimitAndNamesWhatIsWrong) {
  ReadOptions small;
  small.max_bytes = 10;
  EXPECT_THROW(read_piped({"0 0 0 1.5\n", "1 0 0 1.5\n"}, small), ReadError);
  EXPECT_THROW(read_piped({""}), ReadError);
  try {
    read_piped({"0 0 0 1.5\n", "0 0 banana 1.5\n"});
    ADD_FAILURE() << "read";
  } catch (const ReadError& error) {
    EXPECT_EQ(error.file(), "stdin");
    EXPECT_EQ(error.line(), 2u);
  }
}

TEST(ReadDescriptor, ANamedFormatIsNotGuessed) {
  const std::string line =
      "ATOM      1  CA  ALA A   1       0.000   0.000   0.000  1.00  9.67           C  \n";
  EXPECT_EQ(read_piped({line}).format, "PDB");
  ReadOptions options;
  options.format = format_from_id("mmcif");
  EXPECT_THROW(read_piped({line}, options), ReadError);
  for (const char* id : {"pdb", "mmcif", "pqr", "xyz", "tinker", "xyzr", "charmm"}) {
    EXPECT_NE(format_from_id(id), nullptr) << id;
  }
  EXPECT_EQ(format_from_id("auto"), nullptr);
}

}  // namespace
}  // namespace alphascope
