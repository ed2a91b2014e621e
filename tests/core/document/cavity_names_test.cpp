// What is said of a cavity in words.
#include "core/document/cavity_names.hpp"

#include <gtest/gtest.h>

namespace alphascope {
namespace {

TEST(CavityWords, ManyMouthsAreANetworkAndNoPore) {
  EXPECT_EQ(mouths_text(0), "");
  EXPECT_EQ(mouths_text(1), "");
  EXPECT_NE(mouths_text(2).find("2 mouths: it may be a pore"), std::string::npos);
  // A hollow cage of 24 equal parts has 14.
  EXPECT_EQ(mouths_text(14).find("network"), std::string::npos);
  EXPECT_NE(mouths_text(108).find("108 mouths: it is a network"), std::string::npos);
  EXPECT_EQ(mouths_text(108).find("pore"), std::string::npos);
}

}  // namespace
}  // namespace alphascope
