// SPDX-License-Identifier: GPL-3.0-or-later
// Tests descriptions of cavities in words.
#include "core/document/cavities/cavity_names.hpp"
#include "core/cavity_identity/network_radius.hpp"

#include <gtest/gtest.h>

namespace alphascope {
namespace {

TEST(CavityWords, ManyMouthsAreANetworkAndNoPore) {
  EXPECT_EQ(mouths_text(0), "");
  EXPECT_EQ(mouths_text(1), "");
  EXPECT_NE(mouths_text(2).find("2 mouths: it may be a pore"), std::string::npos);
  // A hollow cage of 24 equal parts has 14 mouths.
  EXPECT_EQ(mouths_text(14).find("network"), std::string::npos);
  EXPECT_NE(mouths_text(108).find("108 mouths: it is a network"), std::string::npos);
  EXPECT_EQ(mouths_text(108).find("pore"), std::string::npos);
}

TEST(CavityWords, WhereANetworkFallsApartIsSaidWithWhatWasTried) {
  NetworkEnd end;
  end.alpha_angstrom2 = 2.31;
  end.parts = 512;
  end.radius_angstrom = 1.7;
  end.cavities = 1;
  end.largest_volume_sa_angstrom3 = 1234.5678;
  EXPECT_EQ(
      falls_apart_text(end, 1.4),
      "At a solvent radius of 1.7 Å the network has fallen apart: 1 cavity left, the largest of "
      "1235 Å³. At 1.6 Å it has not. With this solvent radius it falls apart at alpha "
      "2.31 Å², with 512 cavities.");
  EXPECT_EQ(falls_apart_text(end, 1.65).find("1.6 Å"), std::string::npos);
  NetworkEnd none;
  none.largest_radius_angstrom = 4.4;
  EXPECT_EQ(falls_apart_text(none, 1.45), "At a solvent radius of 4.4 Å a network still remains.");
}

}  // namespace
}  // namespace alphascope
