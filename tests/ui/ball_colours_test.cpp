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

}  // namespace
}  // namespace alphascope
