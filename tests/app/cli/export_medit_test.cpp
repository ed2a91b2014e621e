// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the export of meshes for finite elements, Medit's format.
#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/app/cli/cli_fixture.hpp"
#include "tests/app/cli/exported_complex.hpp"

namespace alphascope::testing {
namespace {

const char* const kCrambin = ALPHASCOPE_SOURCE_DIR "/resources/molecules/1crn.pdb";

struct MeditMesh {
  std::vector<std::array<double, 4>> vertices;                             // x, y, z, reference
  std::map<std::string, std::vector<std::vector<std::size_t>>> simplices;  // corners, reference
};

// Reads as the format's manual says: words, with comments from # to the end of the line.
MeditMesh read_medit(const std::string& text) {
  std::string words;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) words += line.substr(0, line.find('#')) + "\n";
  std::istringstream in(words);
  MeditMesh mesh;
  std::string word;
  int version = 0, dimension = 0;
  EXPECT_TRUE(in >> word >> version && word == "MeshVersionFormatted" && version == 2);
  EXPECT_TRUE(in >> word >> dimension && word == "Dimension" && dimension == 3);
  while (in >> word && word != "End") {
    std::size_t count = 0;
    in >> count;
    const std::size_t numbers = word == "Edges" ? 3 : word == "Triangles" ? 4 : 5;
    for (std::size_t n = 0; n < count; ++n) {
      if (word == "Vertices") {
        auto& vertex = mesh.vertices.emplace_back();
        for (double& number : vertex) in >> number;
      } else {
        auto& simplex = mesh.simplices[word].emplace_back(numbers);
        for (std::size_t& number : simplex) in >> number;
      }
    }
    EXPECT_TRUE(in.good()) << word;
  }
  EXPECT_EQ(word, "End");
  return mesh;
}

double volume(const MeditMesh& mesh, const std::vector<std::size_t>& corners) {
  const auto from = [&](std::size_t n, std::size_t axis) {
    return mesh.vertices.at(corners[n] - 1)[axis] - mesh.vertices.at(corners[0] - 1)[axis];
  };
  const auto minor = [&](std::size_t i, std::size_t j) {
    return from(2, i) * from(3, j) - from(2, j) * from(3, i);
  };
  return (from(1, 0) * minor(1, 2) - from(1, 1) * minor(0, 2) + from(1, 2) * minor(0, 1)) / 6;
}

class CliExportMedit : public Cli {
 protected:
  MeditMesh exported(const std::string& molecule, const std::string& arguments) const {
    const std::string file = (folder_ / "c.mesh").string();
    const Outcome made = run("export -q '" + molecule + "' " + arguments + " -o '" + file + "'");
    EXPECT_EQ(made.code, 0) << made.err;
    return read_medit(contents(folder_ / "c.mesh"));
  }
};

TEST_F(CliExportMedit, HasTheSimplicesOfTheComplexWithPositiveVolume) {
  const MeditMesh mesh = exported(kCrambin, "--alpha 1.4");
  const std::string file = (folder_ / "c.alpha").string();
  ASSERT_EQ(run("compute -q '" + std::string(kCrambin) + "' --alpha 1.4 --out '" + file + "'").code,
            0);
  const TextComplex complex(contents(folder_ / "c.alpha"));
  ASSERT_FALSE(complex.simplices[3].empty());
  EXPECT_EQ(mesh.vertices.size(), complex.simplices[0].size());
  const char* const names[] = {"", "Edges", "Triangles", "Tetrahedra"};
  for (std::size_t dimension = 1; dimension < 4; ++dimension) {
    std::set<std::vector<int>> of_mesh, of_complex;
    for (const auto& simplex : mesh.simplices.at(names[dimension])) {
      std::vector<int> balls;
      for (std::size_t n = 0; n <= dimension; ++n) {
        balls.push_back(static_cast<int>(mesh.vertices.at(simplex[n] - 1)[3]) - 1);
      }
      std::sort(balls.begin(), balls.end());
      of_mesh.insert(balls);
    }
    for (const TextSimplex& simplex : complex.simplices[dimension]) {
      of_complex.insert(simplex.balls);
    }
    EXPECT_EQ(of_mesh, of_complex) << names[dimension];
  }
  for (const auto& tetrahedron : mesh.simplices.at("Tetrahedra")) {
    EXPECT_GT(volume(mesh, tetrahedron), 0);
    EXPECT_EQ(tetrahedron[4], 3u) << "interior";
  }
}

TEST_F(CliExportMedit, VerticesNameTheirBalls) {
  // The second ball is inside the first one, and in no simplex.
  const std::string balls = write("four.xyzr", "0 0 0 2\n0.1 0 0 0.5\n3 0 0 2\n").string();
  const MeditMesh mesh = exported(balls, "--alpha 0");
  ASSERT_EQ(mesh.vertices.size(), 2u);
  EXPECT_EQ(mesh.vertices[0], (std::array<double, 4>{0, 0, 0, 1}));
  EXPECT_EQ(mesh.vertices[1], (std::array<double, 4>{3, 0, 0, 3}));
  ASSERT_EQ(mesh.simplices.at("Edges").size(), 1u);
  EXPECT_EQ(mesh.simplices.at("Edges")[0], (std::vector<std::size_t>{1, 2, 3}))
      << "interior, since the balls span a line only";
}

TEST_F(CliExportMedit, TetrahedraAloneAreEnough) {
  const MeditMesh all = exported(kCrambin, "--alpha 1.4");
  const MeditMesh only = exported(kCrambin, "--alpha 1.4 --tetrahedra-only");
  EXPECT_EQ(only.simplices.size(), 1u);
  EXPECT_EQ(only.simplices.at("Tetrahedra").size(), all.simplices.at("Tetrahedra").size());
  EXPECT_LT(only.vertices.size(), all.vertices.size());
}

}  // namespace
}  // namespace alphascope::testing
