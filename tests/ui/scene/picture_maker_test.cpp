// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the recipe of pictures: colours that serve again, texts on what is missing, and pictures of
// several complexes of the same balls. No OpenGL.
#include "ui/scene/picture/picture_maker.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/geometry/lattice_alpha.hpp"
#include "tests/ui/scene/rod_picture.hpp"

namespace alphascope::testing {
namespace {

std::shared_ptr<const EngineAnswer> answer_of(const std::shared_ptr<const BallSet>& balls,
                                              double alpha) {
  auto answer = std::make_shared<EngineAnswer>();
  answer->request.alpha_angstrom2 = alpha;
  answer->balls = balls;
  answer->complex = complex_of(balls, alpha);
  return answer;
}

class Paints : public ::testing::Test {
 protected:
  std::shared_ptr<const Painting> paint(const std::shared_ptr<const EngineAnswer>& answer,
                                        ColourBy by, std::shared_ptr<const Painting> earlier) {
    return make_painting({molecule_, answer, {.by = by}}, std::move(earlier), {});
  }

  std::shared_ptr<const BallSet> balls_ = rod(3);
  std::shared_ptr<const PicturedMolecule> molecule_ =
      std::make_shared<const PicturedMolecule>(carbons(balls_));
  std::shared_ptr<const EngineAnswer> first_ = answer_of(balls_, 0), second_ = answer_of(balls_, 1);
};

TEST_F(Paints, ServeAgainUnlessTheirInputsChange) {
  const auto by_chain = paint(first_, ColourBy::chain, nullptr);
  EXPECT_EQ(paint(second_, ColourBy::chain, by_chain), by_chain);
  EXPECT_NE(paint(second_, ColourBy::element, by_chain), by_chain);
  molecule_ = std::make_shared<const PicturedMolecule>(*molecule_);
  EXPECT_NE(paint(second_, ColourBy::chain, by_chain), by_chain);
}

TEST_F(Paints, OfAComplexFollowItAndKeepItsMeasures) {
  const auto exposed = paint(first_, ColourBy::exposed, nullptr);
  ASSERT_TRUE(exposed->measures);
  EXPECT_EQ(paint(first_, ColourBy::exposed, exposed), exposed);
  EXPECT_NE(paint(second_, ColourBy::exposed, exposed)->measures, exposed->measures);
  EXPECT_EQ(paint(first_, ColourBy::exposed_residue, exposed)->measures, exposed->measures);
}

class MadePictures : public ::testing::Test {
 protected:
  Picture make(double alpha) { return maker().make(answer_of(balls_, alpha), {}, {}); }
  PictureMaker& maker() {
    if (!maker_) maker_.emplace(carbons(balls_), settings_);
    return *maker_;
  }
  static std::string text(const Picture& picture, const std::string& keyword) {
    std::string found;
    for (const auto& [key, value] : picture.texts) {
      if (key == keyword) found += "[" + value + "]";
    }
    return found;
  }

  std::shared_ptr<const BallSet> balls_ = rod(3);
  PictureSettings settings_ = plain_settings(balls_->size(), 64, 64);
  std::optional<PictureMaker> maker_;
};

TEST_F(MadePictures, ShareTheBallsAndFollowAlpha) {
  settings_.display.grown_balls = true;
  settings_.display.ball_scale = 1;
  const Picture low = make(0), high = make(2);
  EXPECT_EQ(low.balls, high.balls);
  EXPECT_NEAR(low.radii.front(), 1.7, 1e-6);
  EXPECT_NEAR(high.radii.front(), std::sqrt(1.7 * 1.7 + 2), 1e-6);
  EXPECT_NE(low.mesh, high.mesh);
  EXPECT_GT(high.mesh->tetrahedra_drawn, low.mesh->tetrahedra_drawn);
}

TEST_F(MadePictures, NameHiddenAtomsAndDrawNoneOfTheirSimplices) {
  settings_.appearance.hidden = AtomSet({{0, 0, 19}});
  const Picture picture = make(1);
  EXPECT_EQ(text(picture, "Hidden atoms"), "[20]");
  EXPECT_EQ(std::count(picture.radii.begin(), picture.radii.end(), 0.0f), 20);
  ASSERT_GT(picture.mesh->outside.size(), 0u);
  for (const DrawnFace& face : picture.mesh->outside.faces) {
    EXPECT_GE(*std::min_element(face.balls.begin(), face.balls.end()), 20u);
  }
}

TEST_F(MadePictures, SayOnceWhatTheirColoursLack) {
  settings_.display.ball_paint.by = ColourBy::b_factor;
  const Picture picture = make(1);
  ASSERT_EQ(maker().missing_colours().size(), 1u);
  EXPECT_EQ(text(picture, "Warning"), "[" + maker().missing_colours().front() + "]");
  settings_.display.balls = false;  // simplices alone have their colours
  maker_.reset();
  EXPECT_EQ(text(make(1), "Warning"), "");
}

TEST_F(MadePictures, AreCutByTheClipWithCaps) {
  EXPECT_FALSE(make(2).caps);
  settings_.clip = read_clip("view");
  maker_.reset();
  const Picture cut = make(2);
  ASSERT_TRUE(cut.caps);
  EXPECT_GT(cut.caps->faces.points(), 0u);
  EXPECT_EQ(cut.style.cut, cut.picture.cut);
  settings_.display.tetrahedra = false;
  maker_.reset();
  EXPECT_FALSE(make(2).caps) << "edges have none";
}

// Centres in a plane: triangles are the largest simplices, and so interior. In space they would be
// singular.
TEST_F(MadePictures, ShowClassesInTheDimensionOfTheBalls) {
  auto flat = std::make_shared<BallSet>();
  for (int i = 0; i < 16; ++i) {
    flat->centres.push_back({1800 * (i % 4) + 10 * (i % 3), 1800 * (i / 4) + 7 * (i % 5), 0});
    flat->radii.push_back(1700);
  }
  balls_ = flat;
  settings_ = plain_settings(balls_->size(), 64, 64);
  settings_.display.triangles = true;
  settings_.display.complex_paint.by = ColourBy::simplex_class;
  const Picture picture = make(0);
  ASSERT_GT(picture.mesh->triangles.size(), 0u);
  EXPECT_EQ(picture.mesh->triangles.faces[0].colour, packed(class_colour(SimplexClass::interior)));
}

}  // namespace
}  // namespace alphascope::testing
