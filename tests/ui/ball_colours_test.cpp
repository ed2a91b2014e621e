#include "ui/scene/ball_colours.hpp"

#include <gtest/gtest.h>

namespace alphascope {
namespace {

TEST(BallColours, AChainKeepsItsColourWhenAnotherIsSwitchedOff) {
  Molecule m;
  for (const char* chain : {"A", "A", "B", "C"}) {
    Atom atom;
    atom.chain = m.names.intern(chain);
    m.atoms.push_back(atom);
  }
  const auto all = colours_by_chain(m, {0, 1, 2, 3});
  EXPECT_EQ(all[0], all[1]);
  EXPECT_NE(all[0], all[2]);
  const auto without_a = colours_by_chain(m, {2, 3});
  EXPECT_EQ(without_a[0], all[2]);
  EXPECT_EQ(without_a[1], all[3]);
}

// The legend says which share a colour stands for.
TEST(BallColours, OfSharesAreThoseOfTheLegend) {
  const ColourLegend legend = share_legend("exposed area");
  EXPECT_EQ(legend.stops.front().value, 0);
  EXPECT_EQ(legend.stops.back().value, 100);
  for (const ColourLegend::Stop& stop : legend.stops) {
    const Rgb8 c = colours_by_share({static_cast<float>(stop.value / 100)}).front();
    EXPECT_NEAR(c.r, 255 * stop.colour.r, 1);
    EXPECT_NEAR(c.g, 255 * stop.colour.g, 1);
    EXPECT_NEAR(c.b, 255 * stop.colour.b, 1);
  }
}

}  // namespace
}  // namespace alphascope
