// SPDX-License-Identifier: GPL-3.0-or-later
// Tests classes of faces against their definition, for every combination of cofaces.
#include "core/complex/face_class.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace alphascope {
namespace {

constexpr SimplexClass kSingular = SimplexClass::singular, kRegular = SimplexClass::regular,
                       kInterior = SimplexClass::interior;

SimplexClass class_among(const std::vector<SimplexClass>& cofaces) {
  std::uint32_t flags = kUnattached;
  for (const SimplexClass c : cofaces) flags |= coface_flags(c);
  return face_class(flags);
}

TEST(FaceClass, IsInteriorOnlyWhereAllCofacesAre) {
  EXPECT_EQ(class_among({}), kSingular);
  EXPECT_EQ(class_among({kInterior}), kInterior);
  EXPECT_EQ(class_among({kInterior, kInterior, kInterior}), kInterior);
  EXPECT_EQ(class_among({kSingular}), kRegular);
  EXPECT_EQ(class_among({kRegular}), kRegular);
  EXPECT_EQ(class_among({kInterior, kRegular, kInterior}), kRegular);
  EXPECT_EQ(class_among({kSingular, kInterior}), kRegular);
}

TEST(FaceClass, OfATriangleNeedsATetrahedronOnEachSide) {
  EXPECT_EQ(triangle_class(0), kSingular);
  EXPECT_EQ(triangle_class(1), kRegular);
  EXPECT_EQ(triangle_class(2), kInterior);
}

TEST(FaceClass, AFaceIsInTheComplexByItselfOrByACoface) {
  EXPECT_FALSE(is_in_complex(0));
  EXPECT_TRUE(is_in_complex(kUnattached));
  EXPECT_TRUE(is_in_complex(coface_flags(kInterior)));
  EXPECT_TRUE(is_in_complex(coface_flags(kSingular)));
  EXPECT_TRUE(is_in_complex(triangle_flags(1)));
}

TEST(FaceClass, TheValueIsTheOwnUnlessAttached) {
  const auto own = [] { return 1.0f; };
  EXPECT_EQ(face_value(kUnattached | coface_flags(kInterior), 2, own), 1);
  EXPECT_EQ(face_value(coface_flags(kInterior), 2, own), 2);
}

// A coface is the pair of its alpha value and of the alpha from which it is interior. At each
// alpha, the class from levels must be the class from the cofaces themselves.
TEST(FaceClass, LevelsSayAtEachAlphaWhatTheCofacesThereSay) {
  const std::vector<std::vector<FaceLevels>> faces = {
      {{1, 1}}, {{1, 3}, {2, 2}}, {{2, kNever}, {1, 1}}, {{1, 1}, {2, kNever}, {3, 4}}, {{2, 4}}};
  for (const auto& cofaces : faces) {
    FaceLevels levels;
    for (const FaceLevels& c : cofaces) levels.add(c.regular_from, c.interior_from);
    for (float alpha = 0; alpha <= 5; alpha += 0.5f) {
      std::uint32_t flags = kUnattached;
      bool all = true;
      for (const FaceLevels& c : cofaces) {
        all = all && c.regular_from <= alpha;
        if (c.regular_from > alpha) continue;
        flags |= coface_flags(c.interior_from <= alpha ? kInterior : kRegular);
      }
      // A coface that does not exist yet leaves a boundary.
      if (!all && flags != kUnattached) flags |= kHasBoundaryCoface;
      EXPECT_EQ(class_at(levels, alpha), face_class(flags)) << "alpha " << alpha;
    }
    levels.lie_on_hull();
    EXPECT_EQ(class_at(levels, 5), kRegular);
  }
  EXPECT_EQ(class_at(FaceLevels::none(), HUGE_VALF), kSingular);
}

}  // namespace
}  // namespace alphascope
