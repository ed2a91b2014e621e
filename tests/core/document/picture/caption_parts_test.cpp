// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the parts of a caption as they are typed.
#include "core/document/picture/caption_parts.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace alphascope {
namespace {

TEST(CaptionParts, AreReadAndWrittenInTheSameWords) {
  EXPECT_EQ(caption_parts_text(read_caption_parts("counts,alpha")), "alpha,counts");
  EXPECT_EQ(caption_parts_text(read_caption_parts("none")), "none");
  EXPECT_EQ(caption_parts_text(read_caption_parts("usual")), "file,alpha,solvent,counts");
  EXPECT_EQ(caption_parts_text(read_caption_parts("all")),
            "file,alpha,solvent,radii,counts,engine,hash");
  for (const CaptionPartInfo& info : caption_parts()) {
    const CaptionParts one = read_caption_parts(info.id);
    EXPECT_TRUE(one.has(info.part));
    EXPECT_EQ(caption_parts_text(one), info.id);
  }
}

TEST(CaptionParts, AWordThatIsNoneIsNamedWithThoseThatAre) {
  try {
    read_caption_parts("alpha,colour");
    FAIL();
  } catch (const std::invalid_argument& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("\"colour\""), std::string::npos) << what;
    EXPECT_NE(what.find("solvent, radii, counts"), std::string::npos) << what;
  }
  EXPECT_THROW(read_caption_parts(""), std::invalid_argument);
  EXPECT_THROW(read_caption_parts(",alpha"), std::invalid_argument);
}

}  // namespace
}  // namespace alphascope
