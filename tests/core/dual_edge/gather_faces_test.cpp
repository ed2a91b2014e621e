// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that edges are found by their triangles. A missing edge is an error, and nothing is
// overwritten.
#include "core/dual_edge/gather_faces.hpp"

#include <gtest/gtest.h>

#include "core/run/internal_error.hpp"

namespace alphascope {
namespace {

class GatherEdges : public ::testing::Test {
 protected:
  GatherEdges() {
    complex_.triangles.simplices.push_back({0, 1, 2});
    complex_.triangles.alpha_values.push_back(5);
    complex_.triangles.classes.push_back(SimplexClass::regular);
    ranges_.resize(3);
    for (EdgeRange& range : ranges_) range.edges = &found_;
    add(0, {0, 1});
    add(0, {0, 2});
  }
  void add(std::size_t ball, std::array<BallIndex, 2> edge) {
    EdgeRange& range = ranges_[ball];
    if (range.begin == range.end) range.begin = range.end = found_.size();
    found_.simplices.push_back(edge);
    found_.values.push_back(5);
    found_.states.push_back(kHasCoface);
    range.end = found_.size();
  }

  AlphaComplex complex_;
  SimplexBuffer<2> found_;
  std::vector<EdgeRange> ranges_;
};

TEST_F(GatherEdges, FindsTheThirdEdgeOfATriangle) {
  add(1, {1, 2});
  found_.values.back() = 9;
  gather_edges(ranges_, complex_);
  EXPECT_EQ(complex_.edges.simplices.back(), (std::array<BallIndex, 2>{1, 2}));
  EXPECT_EQ(complex_.edges.alpha_values.back(), 5);
}

TEST_F(GatherEdges, SaysThatAnEdgeIsMissing) {
  EXPECT_THROW(gather_edges(ranges_, complex_), InternalError);  // ball 1 has no edge
  add(1, {1, 3});
  EXPECT_THROW(gather_edges(ranges_, complex_), InternalError);
  ranges_[1].edges = nullptr;
  try {
    gather_edges(ranges_, complex_);
    FAIL() << "nothing was said";
  } catch (const InternalError& error) {
    EXPECT_NE(std::string(error.what()).find("triangle 0 1 2"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("please report"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace alphascope
