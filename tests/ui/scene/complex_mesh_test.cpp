// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the arrays for drawing against their definition.
#include "ui/scene/mesh/complex_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>

#include "core/geometry/alpha.hpp"
#include "core/molecule/rgb8.hpp"
#include "core/run/work_threads.hpp"
#include "tests/ui/molecule_fixture.hpp"
#include "ui/scene/mesh/simplex_colours.hpp"

namespace alphascope {
namespace {

using testing::complex_of;
using testing::rod;
using testing::two_colours;

struct Case {
  std::shared_ptr<const BallSet> balls = rod();
  BallGeometry geometry{*balls};
  std::vector<Rgb8> colours = two_colours(balls->size());
  AlphaComplex complex = complex_of(balls, 1.0);

  ComplexMesh mesh(const MeshOptions& options) const {
    return build_mesh(geometry, colours, complex, options);
  }
};

using Face = std::array<BallIndex, 3>;

// By definition: each face with the number of its tetrahedra.
std::map<Face, int> counted_faces(const AlphaComplex& complex) {
  std::map<Face, int> count;
  for (const auto& t : complex.tetrahedra.simplices) {
    for (int skip = 0; skip < 4; ++skip) {
      Face face{};
      for (int i = 0, k = 0; i < 4; ++i) {
        if (i != skip) face[k++] = t[i];
      }
      ++count[face];
    }
  }
  return count;
}

std::vector<Face> faces_in_one_tetrahedron(const AlphaComplex& complex) {
  std::vector<Face> faces;
  for (const auto& [face, count] : counted_faces(complex)) {
    if (count == 1) faces.push_back(face);
  }
  return faces;
}

std::vector<Face> sorted_corners(const FaceCells& cells) {
  std::vector<Face> faces;
  for (const DrawnFace& face : cells.faces) {
    faces.push_back(face.balls);
    std::sort(faces.back().begin(), faces.back().end());
  }
  return faces;
}

TEST(ComplexMesh, OpaqueTetrahedraAreDrawnByTheirBoundaryOnly) {
  const Case c;
  ASSERT_GT(c.complex.tetrahedra.size(), 50u);
  const ComplexMesh mesh = c.mesh({});
  const std::vector<Face> outside = faces_in_one_tetrahedron(c.complex);
  EXPECT_EQ(sorted_corners(mesh.outside), outside);
  EXPECT_LT(outside.size(), 4 * c.complex.tetrahedra.size());
  EXPECT_EQ(mesh.tetrahedra.size(), 0u);
  EXPECT_EQ(mesh.tetrahedra_drawn, c.complex.tetrahedra.size());
  EXPECT_EQ(mesh.edges.size(), 0u);
}

// The outside is found from the classes of triangles and, if only tetrahedra are computed, without
// classes.
TEST(ComplexMesh, OutsideIsThatOfTheDefinitionAtAnyAlphaAndWithAnyThreads) {
  for (const double alpha : {-2.0, 0.0, 1.0, 4.0, 40.0}) {
    const auto balls = rod(40);
    const BallGeometry geometry(*balls);
    const AlphaComplex complex = complex_of(balls, alpha);
    const std::vector<Face> wanted = faces_in_one_tetrahedron(complex);
    const auto whole = outer_faces(complex);
    for (const int threads : {1, 3}) {
      WorkThreads(threads).run([&] {
        EXPECT_EQ(outer_faces(complex), whole) << alpha;
        EXPECT_EQ(outer_faces(complex.tetrahedra.simplices), whole) << alpha;
      });
    }
    ASSERT_EQ(whole.size(), wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      EXPECT_EQ(face_vertices(complex.tetrahedra.simplices, whole[i]), wanted[i]);
    }
  }
}

TEST(ComplexMesh, DrawsWhatAnErringEngineSays) {
  Case c;
  std::fill(c.complex.triangles.classes.begin(), c.complex.triangles.classes.end(),
            SimplexClass::regular);
  c.complex.tetrahedra.simplices.resize(1);
  EXPECT_THROW(outer_faces(c.complex), std::invalid_argument);
  EXPECT_EQ(c.mesh({}).outside.size(), 4u) << "of the one tetrahedron";
}

TEST(ComplexMesh, CanBeCancelled) {
  const Case c;
  CancelToken cancel;
  cancel.cancel();
  MeshOptions options;
  EXPECT_THROW(build_mesh(c.geometry, c.colours, c.complex, options, cancel), Cancelled);
  options.shrink = 0.5;
  EXPECT_THROW(build_mesh(c.geometry, c.colours, c.complex, options, cancel), Cancelled);
}

TEST(ComplexMesh, ShrunkOrTranslucentTetrahedraAreAllThere) {
  const Case c;
  MeshOptions options;
  options.shrink = 0.2;
  EXPECT_EQ(c.mesh(options).tetrahedra.balls, c.complex.tetrahedra.simplices);
  EXPECT_EQ(c.mesh(options).outside.size(), 0u);
  options.shrink = 0;
  options.translucent = true;
  EXPECT_EQ(c.mesh(options).tetrahedra.balls, c.complex.tetrahedra.simplices);
}

TEST(ComplexMesh, ShrinkingMovesCornersTowardsTheCentre) {
  const Case c;
  MeshOptions options;
  options.shrink = 0.25;
  EXPECT_EQ(c.mesh(options).tetrahedra.shrink, 0.25f);
  const auto& first = c.complex.tetrahedra.simplices.front();
  std::array<float, 3> centre{};
  for (const BallIndex v : first) {
    for (int k = 0; k < 3; ++k) centre[k] += c.geometry.centres[v][k] / 4;
  }
  const auto corners = shrunk_corners(c.geometry, first, 0.25f);
  for (std::size_t i = 0; i < 4; ++i) {
    for (int k = 0; k < 3; ++k) {
      const float corner = c.geometry.centres[first[i]][k];
      EXPECT_NEAR(corners[i][k], corner + 0.25f * (centre[k] - corner), 1e-4f);
    }
  }
}

TEST(ComplexMesh, BoundaryFacesLookOutwards) {
  const Case c;
  const auto faces = boundary_faces(c.geometry, c.complex.tetrahedra.simplices);
  EXPECT_EQ(faces.size(), faces_in_one_tetrahedron(c.complex).size());
  // By the divergence theorem a surface oriented outwards encloses the volume of the tetrahedra.
  double enclosed = 0, volume = 0;
  const auto det = [&](BallIndex i, BallIndex j, BallIndex k, std::array<double, 3> o) {
    double m[3][3];
    const BallIndex v[3] = {i, j, k};
    for (int r = 0; r < 3; ++r) {
      for (int x = 0; x < 3; ++x) m[r][x] = c.geometry.centres[v[r]][x] - o[x];
    }
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  };
  for (const auto& f : faces) enclosed += det(f[0], f[1], f[2], {0, 0, 0}) / 6;
  for (const auto& t : c.complex.tetrahedra.simplices) {
    const auto& p = c.geometry.centres[t[3]];
    volume += std::abs(det(t[0], t[1], t[2], {p[0], p[1], p[2]})) / 6;
  }
  EXPECT_NEAR(enclosed, volume, 1e-3 * volume);
}

TEST(ComplexMesh, SingularOnlyLeavesOutFacesOfLargerSimplices) {
  const Case c;
  MeshOptions options;
  options.edges = options.triangles = true;
  const auto singular = [](const auto& list) {
    return static_cast<std::size_t>(
        std::count(list.classes.begin(), list.classes.end(), SimplexClass::singular));
  };
  EXPECT_EQ(c.mesh(options).edges.size(), singular(c.complex.edges));
  EXPECT_EQ(c.mesh(options).triangles.size(), singular(c.complex.triangles));
  options.singular_only = false;
  EXPECT_EQ(c.mesh(options).edges.size(), c.complex.edges.size());
  EXPECT_EQ(c.mesh(options).triangles.size(), c.complex.triangles.size());
}

TEST(ComplexMesh, RefusesAComplexOfOtherBalls) {
  const Case c;
  const auto few = rod(1);
  EXPECT_THROW(build_mesh(BallGeometry(*few), two_colours(few->size()), c.complex, {}),
               std::invalid_argument);
}

TEST(BallGeometry, GrownRadiiFollowTheDefinition) {
  const Case c;
  BallStyle style;
  style.grown = true;
  style.scale = 1;
  style.alpha = 1.4;
  EXPECT_NEAR(drawn_radii(c.geometry, style)[0], std::sqrt(1.7 * 1.7 + 1.4), 1e-6);
  style.solvent_radius = 1.4;
  style.alpha = -100;  // the ball is empty, with no imaginary radius
  EXPECT_EQ(drawn_radii(c.geometry, style)[0], 0.0f);
}

TEST(BallGeometry, AxesAreOrthonormalAndFollowTheRod) {
  const Case c;
  EXPECT_NEAR(std::abs(c.geometry.axes[0][2]), 1.0, 0.05);  // the rod runs along z
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      double dot = 0;
      for (int k = 0; k < 3; ++k) dot += c.geometry.axes[i][k] * c.geometry.axes[j][k];
      EXPECT_NEAR(dot, i == j ? 1.0 : 0.0, 1e-9);
    }
  }
}

TEST(BallGeometry, EmptyAndSingleBallAreHarmless) {
  EXPECT_TRUE(BallGeometry(BallSet{}).centres.empty());
  BallSet one;
  one.centres = {{1000, 2000, 3000}};
  one.radii = {1500};
  const BallGeometry geometry(one);
  EXPECT_DOUBLE_EQ(geometry.origin[1], 2.0);
  EXPECT_DOUBLE_EQ(geometry.bounds[0], -1.5);
}

// Colours of elements and chains must not be mixed. A face has the colour of most of its corners,
// and on a tie that of the lowest index. Tries every way to give N corners N colours.
template <std::size_t N>
void expect_most_frequent_colours() {
  std::array<BallIndex, N> corners;
  std::iota(corners.begin(), corners.end(), 0u);
  std::vector<Rgb8> colours(N);
  const auto frequency = [&](const Rgb8& c) {
    return std::count(colours.begin(), colours.end(), c);
  };
  std::size_t ways = 1;
  for (std::size_t i = 0; i < N; ++i) ways *= N;
  for (std::size_t way = 0; way < ways; ++way) {
    for (std::size_t i = 0, rest = way; i < N; ++i, rest /= N) {
      colours[i] = {static_cast<std::uint8_t>(rest % N), 7, 9};
    }
    const Rgb8 expected = *std::max_element(
        colours.begin(), colours.end(),
        [&](const Rgb8& a, const Rgb8& b) { return frequency(a) < frequency(b); });
    EXPECT_EQ(most_frequent_colour(corners, colours), expected) << N << " corners, way " << way;
  }
}

TEST(SimplexColour, IsTheMostFrequentOfItsCornersAndOfSeveralTheFirst) {
  expect_most_frequent_colours<1>();
  expect_most_frequent_colours<2>();
  expect_most_frequent_colours<3>();
  expect_most_frequent_colours<4>();
}

TEST(ComplexMesh, EverySimplexHasOneColourOfItsCorners) {
  Case c;
  for (std::size_t i = 0; i < c.colours.size(); ++i) {
    c.colours[i] = i % 3 == 0 ? testing::kRed : i % 3 == 1 ? testing::kBlue : Rgb8{1, 2, 3};
  }
  MeshOptions options;
  options.boundary = options.triangles = options.edges = true;
  options.singular_only = false;
  options.shrink = 0.2;
  const ComplexMesh mesh = c.mesh(options);
  const auto wanted = [&](const auto& simplex) {
    int most = 0;
    Rgb8 best{};
    for (const BallIndex v : simplex) {
      int same = 0;
      for (const BallIndex w : simplex) same += c.colours[v] == c.colours[w];
      if (same > most) best = c.colours[v];
      most = std::max(most, same);
    }
    return best;
  };
  const auto& tetrahedra = c.complex.tetrahedra.simplices;
  for (std::size_t t = 0; t < tetrahedra.size(); ++t) {
    ASSERT_EQ(unpacked(mesh.tetrahedra.colours[t]), wanted(tetrahedra[t])) << t;
  }
  ASSERT_GT(mesh.boundary.size(), 0u);
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i) {
    ASSERT_EQ(unpacked(mesh.boundary.faces[i].colour),
              wanted(tetrahedra[tetrahedron_of(mesh.boundary.source[i])]));
  }
  ASSERT_EQ(mesh.triangles.size(), c.complex.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    ASSERT_EQ(unpacked(mesh.triangles.faces[i].colour), wanted(c.complex.triangles.simplices[i]));
  }
  for (std::size_t i = 0; i < c.complex.edges.size(); ++i) {
    ASSERT_EQ(mesh.edges.edges[i].balls, c.complex.edges.simplices[i]);
    ASSERT_EQ(unpacked(mesh.edges.edges[i].colour), wanted(c.complex.edges.simplices[i]));
  }
}

// Normals point outwards, as sums of the faces' normals. Over a closed surface all sum to zero.
TEST(ComplexMesh, ASmoothBoundaryHasANormalForEachBall) {
  const Case c;
  MeshOptions options;
  options.tetrahedra = false;
  options.boundary = true;
  EXPECT_TRUE(c.mesh(options).boundary.normals.empty());
  options.smooth_boundary = true;
  const FaceCells boundary = c.mesh(options).boundary;
  ASSERT_EQ(boundary.normals.size(), c.balls->size());
  std::vector<bool> touched(c.balls->size());
  for (const DrawnFace& face : boundary.faces) {
    for (const BallIndex ball : face.balls) touched[ball] = true;
  }
  std::array<double, 3> sum{};
  double outward = 0, length = 0;
  for (std::size_t i = 0; i < touched.size(); ++i) {
    const auto& n = boundary.normals[i];
    if (!touched[i]) {
      EXPECT_EQ(n, (std::array<float, 3>{}));
    }
    for (std::size_t k = 0; k < 3; ++k) {
      sum[k] += n[k];
      length += std::fabs(n[k]);
      if (k < 2) outward += n[k] * c.geometry.centres[i][k];  // the rod lies along z
    }
  }
  for (const double s : sum) EXPECT_LT(std::fabs(s), 1e-4 * length);
  EXPECT_GT(outward, 0);
}

TEST(ComplexMesh, ColoursByAlphaSayWhatTheyMean) {
  const Case c;
  MeshOptions options;
  EXPECT_FALSE(c.mesh(options).scale);
  options.colouring = ComplexColouring::alpha;
  const ComplexMesh mesh = c.mesh(options);
  ASSERT_TRUE(mesh.scale);
  float low = c.complex.alpha_on_lattice.nearest_float();
  for (const float v : c.complex.tetrahedra.alpha_values) low = std::min(low, v);
  EXPECT_DOUBLE_EQ(mesh.scale->alpha_at(1), 1.0);
  EXPECT_DOUBLE_EQ(mesh.scale->alpha_at(0), c.complex.lattice.square_angstrom(low));
  EXPECT_LT(mesh.scale->alpha_at(0), mesh.scale->alpha_at(0.5));
  EXPECT_EQ(mesh.scale->colour(low), mesh.scale->colour_at(0));
  // A colour means the alpha whose colour it is.
  const double middle = mesh.scale->alpha_at(0.5) / c.complex.lattice.square_angstrom(1);
  EXPECT_EQ(mesh.scale->colour(static_cast<float>(middle)), mesh.scale->colour_at(0.5));
  options.edges = true;  // edges come earlier in the list
  EXPECT_LT(c.mesh(options).scale->alpha_at(0), mesh.scale->alpha_at(0));
  options.tetrahedra = options.edges = false;
  EXPECT_FALSE(c.mesh(options).scale) << "nothing is drawn in these colours";
}

}  // namespace
}  // namespace alphascope
