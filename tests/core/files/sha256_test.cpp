// SPDX-License-Identifier: GPL-3.0-or-later
// Tests SHA-256 against vectors of the standard.
#include "core/files/sha256.hpp"

#include "core/geometry/lattice_alpha.hpp"
#include "tests/core/files/temporary_file.hpp"

namespace alphascope {
namespace {

std::string digest(std::string_view text) {
  Sha256 hash;
  hash.update(text);
  return hash.finish();
}

TEST(Sha256, VectorsOfTheStandard) {
  EXPECT_EQ(digest(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(digest("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(digest("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(digest(std::string(1000000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, PiecesGiveTheSameAsTheWhole) {
  const std::string text(1000, 'x');
  for (std::size_t piece = 1; piece < 200; ++piece) {
    Sha256 hash;
    for (std::size_t at = 0; at < text.size(); at += piece) {
      hash.update(std::string_view(text).substr(at, piece));
    }
    ASSERT_EQ(hash.finish(), digest(text)) << piece;
  }
}

TEST(Sha256, NamesTheBytesOnDisk) {
  EXPECT_EQ(read_text("a.xyzr", "1 2 3 1.5\n").sha256, digest("1 2 3 1.5\n"));
  EXPECT_EQ(read_text("a.xyzr",
                      "\xEF\xBB\xBF"
                      "1 2 3 1.5\n")
                .sha256,
            digest("\xEF\xBB\xBF"
                   "1 2 3 1.5\n"));
}

}  // namespace
}  // namespace alphascope
