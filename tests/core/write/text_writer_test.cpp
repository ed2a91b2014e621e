// SPDX-License-Identifier: GPL-3.0-or-later
// Tests text written in pieces: content, limited memory, and cancelling.
#include "core/write/text_writer.hpp"
#include "core/geometry/lattice_alpha.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace alphascope {
namespace {

class TextWriterTest : public ::testing::Test {
 protected:
  ~TextWriterTest() override { std::filesystem::remove(path_); }
  std::string written() const {
    std::ostringstream text;
    text << std::ifstream(path_, std::ios::binary).rdbuf();
    return text.str();
  }
  const std::filesystem::path path_ =
      std::filesystem::path(::testing::TempDir()) / "alphascope_text_writer";
};

TEST_F(TextWriterTest, NumbersHaveTheDigitsThatTheyNeed) {
  AtomicFile file(path_);
  TextWriter text(file);
  text << std::size_t{12} << " ";
  text.shortest(17.047) << " ";
  text.shortest(1e21) << " ";
  text.lattice(-1500, 3) << " ";
  text.lattice(12, -2) << " ";
  text << 1.0 / 3 << " ";
  text.bytes(std::uint16_t{0x4241});
  text.flush();
  file.commit();
  EXPECT_EQ(written(), "12 17.047 1000000000000000000000 -1.500 1200 0.333333333 AB");
}

TEST_F(TextWriterTest, IsCancelledWithinAMegabyte) {
  AtomicFile file(path_);
  CancelToken cancel;
  TextWriter text(file, cancel);
  const auto write_lines = [&](int lines) {
    for (int n = 0; n < lines; ++n) {
      text << "0123456789";
      text.end_line();
    }
  };
  write_lines(200000);
  cancel.cancel();
  EXPECT_THROW(write_lines(100000), Cancelled);
  EXPECT_FALSE(std::filesystem::exists(path_));
}

}  // namespace
}  // namespace alphascope
