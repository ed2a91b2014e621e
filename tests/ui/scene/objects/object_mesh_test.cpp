// SPDX-License-Identifier: GPL-3.0-or-later
// Tests objects as geometry: closed surfaces that follow the chain, bonds, chosen atoms, colours.
#include "ui/scene/objects/object_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/molecule/atom_colours.hpp"
#include "core/molecule/chain_colours.hpp"
#include "core/read/read_molecule.hpp"
#include "core/selection/prepare_balls.hpp"
#include "tests/support/molecules.hpp"
#include "ui/scene/pick/pick.hpp"

namespace alphascope {
namespace {

class ObjectMeshTest : public ::testing::Test {
 protected:
  ObjectMeshTest() { open(sample("4hhb.pdb.gz")); }
  static std::filesystem::path sample(const char* file) {
    return std::filesystem::path(ALPHASCOPE_SOURCE_DIR) / "resources/molecules" / file;
  }
  void open(const std::filesystem::path& file) {
    pictured.molecule = std::make_shared<const Molecule>(read_molecule(file));
    pictured.prepared = std::make_shared<const PreparedBalls>(prepare_balls(*pictured.molecule));
    pictured.geometry = std::make_shared<const BallGeometry>(*pictured.prepared->balls);
    pictured.secondary = std::make_shared<SecondaryOnce>();
    facts = find_object_facts(pictured);
  }
  ObjectMesh built(const std::string& text, const Appearance& appearance = {}) const {
    const ObjectWords words = read_object(text);
    EXPECT_EQ(words.error, "");
    return build_object(pictured, *facts, words.object, appearance);
  }
  const Atom& atom(std::uint32_t i) const { return pictured.molecule->atoms[i]; }
  RealPoint place(std::uint32_t i) const {
    const auto& o = pictured.geometry->origin;
    return position_angstrom(*pictured.molecule, i) - RealPoint{o[0], o[1], o[2]};
  }

  PicturedMolecule pictured;
  std::shared_ptr<const ObjectFacts> facts;
};

RealPoint point(const SmoothMesh& mesh, std::int32_t i) {
  const float* p = &mesh.xyz[3 * static_cast<std::size_t>(i)];
  return {p[0], p[1], p[2]};
}

// Every side of a triangle is that of one other triangle in the other direction, if points at one
// place count as one and triangles without area are left out.
void expect_closed(const SmoothMesh& mesh) {
  using Place = std::array<float, 3>;
  std::map<Place, int> numbers;
  const auto number = [&](std::int32_t i) {
    const float* p = &mesh.xyz[3 * static_cast<std::size_t>(i)];
    return numbers.try_emplace(Place{p[0], p[1], p[2]}, static_cast<int>(numbers.size()))
        .first->second;
  };
  std::map<std::pair<int, int>, int> sides;
  for (std::size_t t = 0; t < mesh.corners.size(); t += 3) {
    const std::array<int, 3> c{number(mesh.corners[t]), number(mesh.corners[t + 1]),
                               number(mesh.corners[t + 2])};
    if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto from = c[k], to = c[(k + 1) % 3];
      sides[{std::min(from, to), std::max(from, to)}] += from < to ? 1 : -1;
    }
  }
  int open = 0;
  for (const auto& [side, sum] : sides) open += sum != 0;
  EXPECT_EQ(open, 0) << "of " << sides.size() << " sides";
}

TEST_F(ObjectMeshTest, SecondaryStructureIsThatOfTheMolecule) {
  EXPECT_EQ(facts->secondary, pictured.secondary->of(*pictured.molecule, facts->atoms));
}

TEST_F(ObjectMeshTest, CartoonIsAClosedSurfaceOfEachDetail) {
  const ObjectMesh whole = built("cartoon");
  EXPECT_GT(whole.cartoon.triangles(), 90000u);
  std::vector<bool> all(pictured.molecule->atoms.size(), true);
  const std::vector<Rgb8> colours(pictured.molecule->atoms.size());
  const CartoonTraces traces = make_traces(*pictured.molecule, pictured.geometry->origin,
                                           *facts->secondary, facts->nucleotides, all, colours);
  ASSERT_EQ(traces.traces.size(), 4u);
  EXPECT_EQ(traces.points, 574u);  // 2 × 141 and 2 × 146 residues
  for (const std::size_t residues :
       {std::size_t{100}, std::size_t{500}, std::size_t{2000}, std::size_t{9000}}) {
    const CartoonDetail detail = cartoon_detail(residues);
    const CartoonMesh mesh = build_cartoon(traces.traces, detail);
    expect_closed(mesh.surface);
    EXPECT_LE(mesh.surface.points(), cartoon_points(traces.traces, detail));
    EXPECT_EQ(mesh.triangles() % mesh.triangles_of_band, 0u);
    EXPECT_EQ(mesh.triangles() / mesh.triangles_of_band, mesh.atom_of_band.size());
  }
}

// The volume within is positive only if triangles are counterclockwise from outside. Normals of
// points agree with those of triangles, but for rims.
TEST_F(ObjectMeshTest, CartoonFacesOutwards) {
  for (const char* file : {"4hhb.pdb.gz", "1crn.pdb"}) {
    open(sample(file));
    const SmoothMesh mesh = built("cartoon").cartoon.surface;
    double volume = 0;
    std::size_t against = 0, counted = 0;
    for (std::size_t t = 0; t < mesh.corners.size(); t += 3) {
      const RealPoint a = point(mesh, mesh.corners[t]), b = point(mesh, mesh.corners[t + 1]),
                      c = point(mesh, mesh.corners[t + 2]);
      const RealPoint face = cross(b - a, c - a);
      volume += dot(a, cross(b, c)) / 6;
      if (length(face) < 1e-3) continue;
      const float* n = &mesh.normals[3 * static_cast<std::size_t>(mesh.corners[t])];
      EXPECT_NEAR(std::hypot(n[0], n[1], n[2]), 1, 1e-4);
      ++counted;
      against += dot(face, {n[0], n[1], n[2]}) < 0;
    }
    EXPECT_GT(volume, 0) << file;
    EXPECT_LT(against, counted / 50) << file;
  }
}

// The ribbon of a helix passes its CA in the middle: the mean of a ring there is the CA.
TEST_F(ObjectMeshTest, HelixPassesThroughItsAtoms) {
  const ObjectMesh mesh = built("cartoon");
  double worst = 0;
  std::size_t tried = 0;
  for (std::size_t r = 0; r < facts->secondary->residues.size(); ++r) {
    if (!is_helix(facts->secondary->kinds[r])) continue;
    const RealPoint ca = place(facts->secondary->residues[r].ca);
    double nearest = 1e9;
    const SmoothMesh& surface = mesh.cartoon.surface;
    for (std::size_t p = 0; p < surface.points(); ++p) {
      nearest = std::min(nearest, length(point(surface, static_cast<std::int32_t>(p)) - ca));
    }
    worst = std::max(worst, std::fabs(nearest - 0.22));  // half the thickness
    if (++tried == 25) break;
  }
  EXPECT_EQ(tried, 25u);
  EXPECT_LT(worst, 0.15);
}

TEST_F(ObjectMeshTest, BandsHaveTheColourOfTheirResidue) {
  const ObjectMesh mesh = built("cartoon,chain");
  const ChainColours colours(*pictured.molecule);
  const SmoothMesh& surface = mesh.cartoon.surface;
  std::size_t other = 0;
  for (std::size_t t = 0; t < mesh.cartoon.triangles(); ++t) {
    const Rgb8 wanted = colours.of(atom(mesh.cartoon.atom_of(t)));
    const std::uint8_t* c = &surface.rgb[3 * static_cast<std::size_t>(surface.corners[3 * t])];
    other += !(Rgb8{c[0], c[1], c[2]} == wanted);
  }
  EXPECT_EQ(other, 0u);
}

TEST_F(ObjectMeshTest, SticksAreTheBondsOfTheChosenAtoms) {
  const ObjectMesh mesh = built("sticks:ligand");
  // A haem has 43 atoms and 50 bonds. The ions of phosphorus have none, so they are balls.
  EXPECT_EQ(mesh.sticks.rods.size(), 200u);
  ASSERT_TRUE(mesh.spheres);
  EXPECT_EQ(mesh.spheres->centres.size(), 2u);
  for (const DrawnEdge& rod : mesh.sticks.rods.edges) {
    const std::uint32_t a = mesh.sticks.atom_of_place[rod.balls[0]];
    const std::uint32_t b = mesh.sticks.atom_of_place[rod.balls[1]];
    EXPECT_EQ(atom(a).kind, ResidueKind::ligand);
    EXPECT_EQ(unpacked(rod.colour), element_colour(atom(a).element));
    EXPECT_EQ(unpacked(rod.other), element_colour(atom(b).element));
    EXPECT_LT(length(place(a) - place(b)), 2.6);
  }
  EXPECT_EQ(built("balls_and_sticks:ligand").spheres->centres.size(), 174u);
  EXPECT_EQ(built("points:ligand").dots.points(), 174u);
  EXPECT_TRUE(built("sticks:none").empty());
}

TEST_F(ObjectMeshTest, HiddenAtomsAndOwnColoursCount) {
  const Molecule& m = *pictured.molecule;
  Appearance appearance;
  appearance.hidden = named_set(m, "chain A");
  appearance.colours.push_back({{1, 2, 3}, named_set(m, "chain B")});
  const ObjectMesh mesh = built("sticks:ligand", appearance);
  for (const std::uint32_t i : mesh.sticks.atom_of_place) {
    EXPECT_NE(m.text(atom(i).chain), "A");
  }
  for (const DrawnEdge& rod : mesh.sticks.rods.edges) {
    const Atom& a = atom(mesh.sticks.atom_of_place[rod.balls[0]]);
    EXPECT_EQ(unpacked(rod.colour) == (Rgb8{1, 2, 3}), m.text(a.chain) == "B");
  }
}

// Each rung ends at the nitrogen that the sugar is bound to, a corner of the base's plate.
TEST_F(ObjectMeshTest, LadderHasARungAndAPlateForEachNucleotide) {
  ALPHASCOPE_NEED_TEST_DATA();
  open(testing::test_data_folder() / "ladder/1bna.pdb");
  const ObjectMesh mesh = built("cartoon");
  ASSERT_EQ(mesh.sticks.rods.size(), 24u);
  expect_closed(mesh.cartoon.surface);
  const CartoonTraces traces =
      make_traces(*pictured.molecule, pictured.geometry->origin, *facts->secondary,
                  facts->nucleotides, std::vector<bool>(pictured.molecule->atoms.size(), true),
                  std::vector<Rgb8>(pictured.molecule->atoms.size()));
  ASSERT_EQ(traces.plates.size(), 24u);
  std::size_t triangles = 0;
  for (std::size_t k = 0; k < traces.plates.size(); ++k) {
    const Nucleotide& n = facts->nucleotides[k];
    const bool purine = traces.plates[k].corners == 9;
    EXPECT_EQ(traces.plates[k].corners, purine ? 9u : 6u);
    triangles += purine ? 2 * 7 + 2 * 9 : 2 * 4 + 2 * 6;
    EXPECT_EQ(length(traces.rungs[k].to - place(n.outline[purine ? 4 : 0])), 0) << k;
  }
  EXPECT_EQ(mesh.cartoon.atom_of_plate_triangle.size(), triangles);
  EXPECT_EQ(mesh.cartoon.atom_of_band.size() * mesh.cartoon.triangles_of_band + triangles,
            mesh.cartoon.triangles());
}

// A line through the middle of either ring, along the normal of the base.
TEST_F(ObjectMeshTest, AHitOfAPlateIsAnAtomOfItsBase) {
  ALPHASCOPE_NEED_TEST_DATA();
  open(testing::test_data_folder() / "ladder/1bna.pdb");
  const PickLayers layers = object_layers(std::make_shared<const ObjectMesh>(built("cartoon")));
  for (const Nucleotide& n : facts->nucleotides) {
    const auto corner = [&](std::size_t k) { return place(n.outline[k]); };
    const RealPoint across = unit_vector(cross(corner(1) - corner(0), corner(2) - corner(0)));
    std::vector<RealPoint> middles{0.5 * (corner(0) + corner(3))};
    if (n.corners == 9) middles.push_back(0.5 * (0.5 * (corner(3) + corner(7)) + corner(5)));
    for (const RealPoint& middle : middles) {
      const RealPoint from = middle + across;  // Å; the next base is 3.4 Å away
      PickLine line;
      line.ray = {{from.x, from.y, from.z}, {-across.x, -across.y, -across.z}};
      const auto hit = nearest_hit(layers, line);
      ASSERT_TRUE(hit);
      EXPECT_EQ(hit->index, n.base);
    }
  }
}

TEST_F(ObjectMeshTest, PlatesFaceOutwards) {
  BasePlate plate;
  plate.corners = 6;
  for (std::size_t k = 0; k < 6; ++k) {
    const double angle = M_PI * static_cast<double>(k) / 3;
    plate.outline[k] = {1.4 * std::cos(angle), 1.4 * std::sin(angle), 0.1 * (k % 2)};
  }
  SmoothMesh mesh;
  add_plate(plate, mesh);
  expect_closed(mesh);
  for (std::size_t t = 0; t < mesh.corners.size(); t += 3) {
    const RealPoint a = point(mesh, mesh.corners[t]), b = point(mesh, mesh.corners[t + 1]),
                    c = point(mesh, mesh.corners[t + 2]);
    const RealPoint face = cross(b - a, c - a);
    const float* n = &mesh.normals[3 * static_cast<std::size_t>(mesh.corners[t])];
    EXPECT_GT(dot(face, {n[0], n[1], n[2]}), 0) << t;
    EXPECT_GT(dot(face, (1.0 / 3) * (a + b + c)), 0) << t;
  }
}

TEST_F(ObjectMeshTest, AHitOfAStickIsItsNearerAtom) {
  const auto mesh = std::make_shared<const ObjectMesh>(built("sticks:ligand"));
  const PickLayers layers = object_layers(mesh);
  std::size_t tried = 0;
  for (std::size_t i = 0; i < mesh->sticks.rods.size(); i += 7) {
    const auto& ends = mesh->sticks.rods.edges[i].balls;
    for (const int end : {0, 1}) {
      const std::uint32_t a = mesh->sticks.atom_of_place[ends[static_cast<std::size_t>(end)]];
      const std::uint32_t b = mesh->sticks.atom_of_place[ends[static_cast<std::size_t>(1 - end)]];
      const RealPoint at = place(a) + 0.3 * (place(b) - place(a));
      RealPoint across, up;
      normals_of(unit_vector(place(b) - place(a)), across, up);
      // From just outside, so that nothing else lies before it.
      const RealPoint from = at + 0.3 * across;
      PickLine line;
      line.ray = {{from.x, from.y, from.z}, {-across.x, -across.y, -across.z}};
      const auto hit = nearest_hit(layers, line);
      ASSERT_TRUE(hit);
      EXPECT_EQ(hit->index, a);
      ++tried;
    }
  }
  EXPECT_GT(tried, 50u);
}

TEST_F(ObjectMeshTest, StopsWhenCancelled) {
  const CancelToken stop;
  stop.cancel();
  EXPECT_THROW(build_object(pictured, *facts, read_object("cartoon").object, {}, stop), Cancelled);
}

}  // namespace
}  // namespace alphascope
