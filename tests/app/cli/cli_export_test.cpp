// SPDX-License-Identifier: GPL-3.0-or-later
// Tests alphascope-cli export: every format is read back, mostly without other programs' libraries.
// Tests with VTK, CGAL and gemmi are in separate files.
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <set>

#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/real_point.hpp"
#include "core/read/read_molecule.hpp"
#include "tests/app/cli/cli_fixture.hpp"

namespace alphascope::testing {
namespace {

const char* const kCrambin = ALPHASCOPE_SOURCE_DIR "/resources/molecules/1crn.pdb";
const char* const kHaemoglobin = ALPHASCOPE_SOURCE_DIR "/resources/molecules/4hhb.pdb.gz";

class CliExport : public Cli {
 protected:
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  // Crambin at alpha 1.4 by default.
  std::string exported(const std::string& name, const std::string& arguments = "--alpha 1.4",
                       const std::string& molecule = kCrambin) const {
    const Outcome made =
        run("export -q '" + molecule + "' " + arguments + " -o '" + path(name) + "'");
    EXPECT_EQ(made.code, 0) << made.err;
    return contents(folder_ / name);
  }
};

// Reads the words of a text one by one.
class Words {
 public:
  explicit Words(const std::string& text) : text_(text) {}
  template <class T>
  T next() {
    T value{};
    EXPECT_TRUE(text_ >> value);
    return value;
  }
  bool at_end() { return (text_ >> std::ws).eof(); }

 private:
  std::istringstream text_;
};

TEST_F(CliExport, OneThingIsNotSaidToBeMany) {
  const std::string balls = write("pair.xyzr", "0 0 0 2\n3 0 0 2\n").string();
  const std::string out = (folder_ / "pair.alpha").string();
  const Outcome written = run("export --alpha 0 '" + balls + "' --output '" + out + "'");
  EXPECT_EQ(written.code, 0) << written.err;
  EXPECT_TRUE(contains(written.out, "2 vertices, 1 edge, 0 triangles, 0 tetrahedra"))
      << written.out;
}

// Two distant tetrahedra. All balls of one meet: its circumradius is 1.5 √3 = 2.6 Å.
TEST_F(CliExport, AnStlFileSaysItsPiecesAndItsUnit) {
  std::string tetrahedra;
  for (const char* x : {"0", "50"}) {
    const std::string far = std::to_string(std::stoi(x) + 3);
    for (const std::string& place : {std::string(x) + " 0 0", far + " 0 0", std::string(x) + " 3 0",
                                     std::string(x) + " 0 3"}) {
      tetrahedra += place + " 3\n";
    }
  }
  const std::string balls = write("two.xyzr", tetrahedra).string();
  for (const char* name : {"two.stl", "two.ply"}) {
    const Outcome made = run("export --alpha 0 '" + balls + "' -o '" + path(name) + "'");
    ASSERT_EQ(made.code, 0) << made.err;
    EXPECT_TRUE(contains(made.out, "boundary of 2 solids")) << made.out;
    EXPECT_TRUE(contains(made.out, "1 unit of the file is 1 Å")) << made.out;
    EXPECT_EQ(contains(made.out, "2 separate pieces"), name == std::string("two.stl")) << name;
  }
}

TEST_F(CliExport, BallsAreTheSameBallsAgain) {
  const json whole = compute_json(std::string(kHaemoglobin) + " --alpha 1.4 --solvent 1.4");
  for (const char* name : {"b.xyzr", "b.pqr"}) {
    exported(name, "--alpha 1.4 --solvent 1.4", kHaemoglobin);
    const json again = compute_json(path(name) + " --alpha 1.4 --radii file");
    EXPECT_EQ(again["hash"], whole["hash"]) << name;
    EXPECT_EQ(again["counts"], whole["counts"]) << name;
  }
  const Molecule pqr = read_molecule(folder_ / "b.pqr"), file = read_molecule(kHaemoglobin);
  ASSERT_TRUE(pqr.has_file_radii);
  EXPECT_EQ(pqr.text(pqr.atoms[1].name), "CA");
  EXPECT_EQ(pqr.text(pqr.atoms.back().residue_name), "HEM");
  EXPECT_EQ(pqr.text(pqr.atoms.back().chain), "D");
  EXPECT_EQ(pqr.atoms.back().residue_number, 148);
}

// Values that do not fit into the columns of the PDB format.
TEST_F(CliExport, PqrHoldsLargeNumbersAndLongNames) {
  const std::string far =
      write("far.xyzr", "-1234.5678 2000.25 -999.125 1.5\n12345.5 -0.0001 7 2.0625\n").string();
  exported("far.pqr", "--alpha 0", far);
  EXPECT_EQ(compute_json(path("far.pqr") + " --alpha 9 --radii file")["hash"],
            compute_json(far + " --alpha 9")["hash"]);
  const Molecule pqr = read_molecule(folder_ / "far.pqr");
  EXPECT_EQ(pqr.lattice.angstrom(pqr.atoms[0].position.x), -1234.5678);
  EXPECT_EQ(pqr.lattice.angstrom(pqr.atoms[1].file_radius), 2.0625);
}

// Numbers that fill their eight columns, such as -100.000 and 1000.000, would touch the number
// before.
TEST_F(CliExport, PqrNumbersNeverTouch) {
  const struct {
    const char* ball;
    bool columns;
  } cases[] = {{"-99.999 -99.999 -99.999 1.5", true},
               {"-100 0 0 1.5", false},
               {"0 -100 0 1.5", false},
               {"0 0 -100 1.5", false},
               {"-123.456 -234.567 -345.678 1.5", false},
               {"999.999 999.999 999.999 1.5", true},
               {"1000 0 0 1.5", false},
               {"0 1000 0 1.5", false},
               {"0 0 1000 1.5", false}};
  for (const auto& c : cases) {
    const std::string file = write("t.xyzr", std::string(c.ball) + "\n0 0 0 1.5\n").string();
    const std::string text = exported("t.pqr", "--alpha 0", file);
    std::istringstream lines(text);
    int atoms = 0;
    for (std::string line; std::getline(lines, line);) {
      if (!line.starts_with("ATOM")) continue;
      std::istringstream words(line);
      int fields = 0;
      for (std::string word; words >> word;) ++fields;
      EXPECT_EQ(fields, 10) << line;  // without a chain
      // The columns of x in the PDB format: 31 to 38.
      if (c.columns) {
        EXPECT_EQ(line.substr(27, 3), "   ") << line;
      }
      ++atoms;
    }
    EXPECT_EQ(atoms, 2) << text;
    exported("again.xyzr", "--alpha 0 --radii file", path("t.pqr"));
    const Molecule before = read_molecule(file), again = read_molecule(folder_ / "again.xyzr");
    ASSERT_EQ(again.atoms.size(), 2u);
    EXPECT_EQ(again.atoms[0].position, before.atoms[0].position) << c.ball;
  }
}

// Facets are counterclockwise seen from outside, and normals agree.
TEST_F(CliExport, StlNormalsAgreeWithTheOrderOfVertices) {
  Words words(exported("n.stl", "--alpha 0 --solvent 1.4"));
  std::size_t facets = 0, agree = 0;
  const auto point = [&] {
    const double x = words.next<double>(), y = words.next<double>();
    return RealPoint{x, y, words.next<double>()};
  };
  while (!words.at_end()) {
    if (words.next<std::string>() != "normal") continue;
    const RealPoint normal = point();
    std::array<RealPoint, 3> corners;
    for (RealPoint& corner : corners) {
      while (words.next<std::string>() != "vertex") {
      }
      corner = point();
    }
    const RealPoint by_order = cross(corners[1] - corners[0], corners[2] - corners[0]);
    EXPECT_NEAR(dot(normal, normal), 1, 1e-4);  // to the number of written digits
    agree += dot(normal, by_order) > 0.999 * length(by_order);
    ++facets;
  }
  EXPECT_EQ(facets, 464u);
  EXPECT_EQ(agree, facets);
}

TEST_F(CliExport, TheAlphaTextIsThatOfCompute) {
  const Outcome computed =
      run("compute " + std::string(kCrambin) + " --alpha 1.4 --out '" + path("c.alpha") + "'");
  ASSERT_EQ(computed.code, 0);
  EXPECT_EQ(exported("e.alpha"), contents(folder_ / "c.alpha"));
}

TEST_F(CliExport, ParallelAcsLayoutHasAllSimplices) {
  Words words(exported("c.txt"));
  Words alpha(exported("c.alpha"));
  const std::size_t balls = words.next<std::size_t>(), edges = words.next<std::size_t>(),
                    triangles = words.next<std::size_t>(), tetrahedra = words.next<std::size_t>();
  const json counts = compute_json(std::string(kCrambin) + " --alpha 1.4")["counts"];
  EXPECT_EQ(balls, 327u);
  EXPECT_EQ(edges, counts["edges"]);
  EXPECT_EQ(triangles, counts["triangles"]);
  EXPECT_EQ(tetrahedra, counts["tetrahedra"]);
  while (alpha.next<std::string>() != "balls") continue;
  ASSERT_EQ(alpha.next<std::size_t>(), balls);
  for (std::size_t n = 0; n < 4 * balls; ++n) ASSERT_EQ(words.next<double>(), alpha.next<double>());
  const auto section = [&](const std::string& name, std::size_t count, int corners) {
    while (alpha.next<std::string>() != name) continue;
    ASSERT_EQ(alpha.next<std::size_t>(), count);
    for (std::size_t n = 0; n < count; ++n) {
      for (int k = 0; k < corners; ++k) ASSERT_EQ(words.next<int>(), alpha.next<int>()) << name;
      alpha.next<std::string>();
      alpha.next<std::string>();
    }
  };
  section("edges", edges, 2);
  section("triangles", triangles, 3);
  section("tetrahedra", tetrahedra, 4);
  EXPECT_TRUE(words.at_end());
  const std::string text = contents(folder_ / "c.txt");
  EXPECT_EQ(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')),
            1 + balls + edges + triangles + tetrahedra)
      << "a line for each";
}

// Checks the counts at the head of VTK files. Another test reads the files with VTK itself.
TEST_F(CliExport, VtkFilesSayHowManyCellsTheyHave) {
  const json counts = compute_json(std::string(kCrambin) + " --alpha 1.4")["counts"];
  const auto said = [&](const char* name, std::size_t number) {
    return std::string(name) + "=\"" + std::to_string(number) + "\"";
  };
  const std::size_t vertices = counts["vertices"], edges = counts["edges"],
                    triangles = counts["triangles"], tetrahedra = counts["tetrahedra"];
  const std::string grid = exported("c.vtu");
  EXPECT_TRUE(contains(grid, "<Piece NumberOfPoints=\"327\" " +
                                 said("NumberOfCells", vertices + edges + triangles + tetrahedra)));
  EXPECT_TRUE(contains(grid, "<Cells>"));
  const std::string polygons = exported("c.vtp");
  EXPECT_TRUE(contains(polygons, said("NumberOfVerts", vertices)));
  EXPECT_TRUE(contains(polygons, said("NumberOfLines", edges)));
  EXPECT_TRUE(contains(polygons, said("NumberOfPolys", triangles)));
  for (const char* part : {"<Verts>", "<Lines>", "<Polys>"}) {
    EXPECT_TRUE(contains(polygons, part)) << part;
  }
}

TEST_F(CliExport, CountsAreRowsOfACsv) {
  const json whole = compute_json(std::string(kCrambin) + " --alpha 1.4");
  std::map<std::string, std::string> values;
  for (auto& row : csv_rows(exported("c.csv"))) values[row["quantity"]] = row["value"];
  EXPECT_EQ(values["hash"], whole["hash"]);
  EXPECT_EQ(values["sha256"].size(), 64u);
  for (const char* kind : {"vertices", "edges", "triangles", "tetrahedra"}) {
    EXPECT_EQ(values[kind], whole["counts"][kind].dump());
  }
  EXPECT_EQ(std::stoi(values["singular triangles"]) + std::stoi(values["regular triangles"]) +
                std::stoi(values["interior triangles"]),
            whole["counts"]["triangles"]);
  EXPECT_EQ(values["Euler characteristic"], whole["euler_characteristic"].dump());
  EXPECT_GT(std::stod(values["wall time"]), 0);
  EXPECT_NEAR(std::stod(values["volume of tetrahedra"]), 503.428784097, 1e-9);
}

// --- GLB: the specification's rules for chunks, accessors and views.

std::uint32_t word(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  EXPECT_LE(at + sizeof value, bytes.size());
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

struct Accessor {
  std::string data;
  std::size_t count;
  json head;
  template <class T>
  T at(std::size_t n) const {
    T value;
    std::memcpy(&value, data.data() + n * sizeof value, sizeof value);
    return value;
  }
};

Accessor accessor(const json& head, const std::string& data, const json& index, std::size_t size) {
  const json& of = head["accessors"][index.get<std::size_t>()];
  const json& view = head["bufferViews"][of["bufferView"].get<std::size_t>()];
  const std::size_t begin = view["byteOffset"], length = view["byteLength"], count = of["count"];
  EXPECT_EQ(begin % 4, 0u);
  EXPECT_EQ(length, count * size);
  EXPECT_LE(begin + length, data.size());
  return {data.substr(begin, length), count, of};
}

TEST_F(CliExport, GlbIsAsItsSpecificationSays) {
  const std::string bytes = exported("c.glb");
  ASSERT_EQ(bytes.substr(0, 4), "glTF");
  ASSERT_EQ(word(bytes, 4), 2u);
  ASSERT_EQ(word(bytes, 8), bytes.size());
  const std::size_t size = word(bytes, 12);
  ASSERT_EQ(size % 4, 0u);
  ASSERT_EQ(bytes.substr(16, 4), "JSON");
  const json head = json::parse(bytes.substr(20, size));
  const std::string data = bytes.substr(28 + size);
  ASSERT_EQ(word(bytes, 20 + size), data.size());
  ASSERT_EQ(bytes.substr(24 + size, 4), std::string("BIN\0", 4));
  EXPECT_EQ(head["buffers"][0]["byteLength"], data.size());
  const json& header = head["asset"]["extras"]["header"];
  EXPECT_TRUE(std::any_of(header.begin(), header.end(), [](const json& entry) {
    return entry[0] == "sha256";
  })) << header;
  ASSERT_EQ(head["meshes"].size(), 41u);  // one for each solid
  EXPECT_EQ(head["scenes"][0]["nodes"].size(), 41u);
  std::size_t triangles = 0;
  for (const json& mesh : head["meshes"]) {
    const json& primitive = mesh["primitives"][0];
    const Accessor points = accessor(head, data, primitive["attributes"]["POSITION"], 12),
                   colours = accessor(head, data, primitive["attributes"]["COLOR_0"], 8),
                   indices = accessor(head, data, primitive["indices"], 4);
    EXPECT_EQ(colours.count, points.count);
    EXPECT_EQ(colours.head["normalized"], true);
    for (int axis = 0; axis < 3; ++axis) {
      float low = INFINITY, high = -INFINITY;
      for (std::size_t n = 0; n < points.count; ++n) {
        low = std::min(low, points.at<std::array<float, 3>>(n)[axis]);
        high = std::max(high, points.at<std::array<float, 3>>(n)[axis]);
      }
      EXPECT_EQ(points.head["min"][axis].get<float>(), low);
      EXPECT_EQ(points.head["max"][axis].get<float>(), high);
    }
    for (std::size_t n = 0; n < indices.count; ++n) {
      ASSERT_LT(indices.at<std::uint32_t>(n), points.count);
    }
    triangles += indices.count / 3;
  }
  EXPECT_EQ(triangles, 850u);
}

// sRGB becomes linear light. Carbon's (122, 130, 142) of 255 become ((s + 0.055) / 1.055)^2.4 of
// 65,535.
TEST_F(CliExport, ColoursOfGlbAreLinear) {
  const std::string bytes = exported("l.glb", "--alpha 1.4 --colours element");
  const std::size_t size = word(bytes, 12);
  const json head = json::parse(bytes.substr(20, size));
  const std::string data = bytes.substr(28 + size);
  std::set<std::array<std::uint16_t, 4>> found;
  for (const json& mesh : head["meshes"]) {
    const Accessor colours =
        accessor(head, data, mesh["primitives"][0]["attributes"]["COLOR_0"], 8);
    for (std::size_t n = 0; n < colours.count; ++n) {
      found.insert(colours.at<std::array<std::uint16_t, 4>>(n));
    }
  }
  EXPECT_EQ(found.size(), 4u);  // C, N, O, S
  EXPECT_TRUE(found.contains({12754, 14629, 17456, 65535})) << ::testing::PrintToString(found);
}

TEST_F(CliExport, ColoursAreThoseOfElementsChainsOrSolids) {
  const auto colours = [&](const char* which) {
    std::istringstream lines(exported("c.obj", "--alpha 3 --colours " + std::string(which)));
    std::set<std::string> found;
    for (std::string line; std::getline(lines, line);) {
      if (!line.starts_with("v ")) continue;
      std::istringstream words(line.substr(2));
      std::string x, y, z, rest;
      words >> x >> y >> z;
      std::getline(words, rest);
      found.insert(rest);
    }
    return found;
  };
  EXPECT_EQ(colours("element").size(), 4u);  // C, N, O, S
  EXPECT_EQ(colours("chain").size(), 1u);
  EXPECT_EQ(colours("solid").size(), 3u);
}

// The complex has more solids than other programs draw well. So small solids beyond the first 999
// become one object.
TEST_F(CliExport, SmallSolidsBeyondTheFirstAreOneObject) {
  const std::string text = exported("h.obj", "--alpha 0", kHaemoglobin);
  std::size_t objects = 0, triangles = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    objects += line.starts_with("o ");
    triangles += line.starts_with("f ");
  }
  EXPECT_EQ(objects, 1000u);  // of 1,094 solids
  EXPECT_EQ(triangles, 6110u);
  EXPECT_TRUE(contains(text, "o solid_999\n"));
  EXPECT_FALSE(contains(text, "o solid_1000\n"));
  EXPECT_TRUE(contains(text, "o smaller_solids\n"));
}

// --- Scripts. Their commands are those in the programs' manuals.

std::string without_comments(const std::string& script) {
  std::istringstream lines(script);
  std::string kept;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("#")) kept += line + "\n";
  }
  return kept;
}

TEST_F(CliExport, ScriptsComeWithTheFilesThatTheyOpen) {
  const std::string cxc = exported("show me.cxc");
  EXPECT_TRUE(contains(cxc, "# sha256 "));
  EXPECT_TRUE(contains(cxc, "open '" + path("show me-balls.pqr") + "' format pqr id 1"));
  EXPECT_TRUE(contains(cxc, "open '" + path("show me-boundary.glb") + "' id 2"));
  EXPECT_TRUE(fs::exists(folder_ / "show me-balls.pqr"));
  EXPECT_TRUE(contents(folder_ / "show me-boundary.glb").starts_with("glTF"));
  const std::set<std::string> known{"open", "hide", "show", "style", "size", "color", "view"};
  std::istringstream lines(without_comments(cxc));
  for (std::string line; std::getline(lines, line);) {
    EXPECT_TRUE(known.count(line.substr(0, line.find(' ')))) << line;
  }
}

TEST_F(CliExport, ThePyMolScriptIsPythonThatReadsTheBoundary) {
  if (std::system("python3 -c '' 2>/dev/null") != 0) GTEST_SKIP() << "needs python3";
  exported("c.pml");
  // PyMOL's part of the script, with its commands replaced by ones that print their arguments.
  const std::string stub = write("stub.py", R"(
import sys, types
calls = []
class Cmd:
    def __getattr__(self, name):
        known = ('load alter rebuild hide show set color load_cgo zoom').split()
        assert name in known, name
        return lambda *a: calls.append((name,) + a)
pymol = types.ModuleType('pymol')
pymol.cmd = Cmd()
pymol.cgo = types.SimpleNamespace(BEGIN=2.0, TRIANGLES=4.0, END=3.0, NORMAL=5.0, COLOR=6.0, VERTEX=4.5)
sys.modules['pymol'] = pymol
lines = open(sys.argv[1]).read().split('\n')
code = lines[lines.index('python') + 1:lines.index('python end')]
exec(compile('\n'.join(code), 'script', 'exec'))
mesh = [c for c in calls if c[0] == 'load_cgo'][0][1]
print(mesh.count(4.5), [c for c in calls if c[0] == 'load'][0][1])
)")
                               .string();
  const std::string command =
      "python3 '" + stub + "' '" + path("c.pml") + "' > '" + path("said") + "' 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << contents(folder_ / "said");
  EXPECT_EQ(contents(folder_ / "said"), "2550 " + path("c-balls.pqr") + "\n");
}

TEST_F(CliExport, TheVmdScriptIsTclThatDrawsTheBoundary) {
  if (std::system("echo exit | tclsh 2>/dev/null") != 0) GTEST_SKIP() << "needs tclsh";
  const std::string name = "v[exit]\\ $x";  // commands if they were not quoted
  exported(name + ".tcl");
  const std::string stub = write("stub.tcl", R"(
set drawn 0
set opened {}
proc mol args { if {[lindex $args 0] eq "new"} { set ::opened [lindex $args 1] } }
proc draw args { if {[lindex $args 0] eq "triangle"} { incr ::drawn } }
proc display args {}
source [lindex $argv 0]
puts "$drawn $opened"
)")
                               .string();
  const std::string command =
      "tclsh '" + stub + "' '" + path(name + ".tcl") + "' > '" + path("said") + "' 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << contents(folder_ / "said");
  EXPECT_EQ(contents(folder_ / "said"), "850 " + path(name + "-balls.pqr") + "\n");
}

// --- Conventions

TEST_F(CliExport, StandardOutputNeedsTheFormatSaid) {
  const Outcome made = run("export " + std::string(kCrambin) + " --alpha 1.4 --as off -o -");
  EXPECT_EQ(made.code, 0) << made.err;
  EXPECT_EQ(made.out, exported("c.off"));
  EXPECT_TRUE(contains(made.err, "41 solids")) << made.err;
  EXPECT_EQ(run("export " + std::string(kCrambin) + " --alpha 1.4 -o -").code, 2);
  EXPECT_EQ(run("export " + std::string(kCrambin) + " --alpha 1.4 --as cxc -o -").code, 2);
}

TEST_F(CliExport, UnknownEndingsAreToldTheKnownOnes) {
  const Outcome made =
      run("export " + std::string(kCrambin) + " --alpha 1.4 -o '" + path("c.docx") + "'");
  EXPECT_EQ(made.code, 2);
  EXPECT_TRUE(contains(made.err, ".ply, .obj, .stl, .off, .glb, .vtu")) << made.err;
  EXPECT_FALSE(fs::exists(folder_ / "c.docx"));
  EXPECT_TRUE(contains(exported("C.OFF"), "COFF\n"));
}

TEST_F(CliExport, OfTetrahedraOnlyWhatNeedsMoreIsRefused) {
  const std::string only = "--alpha 1.4 --tetrahedra-only";
  EXPECT_EQ(exported("t.stl", only).size(), exported("c.stl").size());
  exported("t.vtu", only);
  for (const char* name : {"t.vtp", "t.txt"}) {
    const Outcome made =
        run("export " + std::string(kCrambin) + " " + only + " -o '" + path(name) + "'");
    EXPECT_EQ(made.code, 2) << name;
    EXPECT_TRUE(contains(made.err, "only tetrahedra were computed")) << made.err;
    EXPECT_FALSE(fs::exists(folder_ / name));
  }
}

TEST_F(CliExport, WithoutTetrahedraFilesAreStillRead) {
  const std::string flat = write("flat.xyzr", "0 0 0 1\n3 0 0 1\n0 3 0 1\n").string();
  for (const char* name : {"f.ply", "f.obj", "f.stl", "f.off", "f.glb", "f.vtu", "f.vtp"}) {
    const Outcome made = run("export " + flat + " --alpha 0 -o '" + path(name) + "'");
    EXPECT_EQ(made.code, 0) << made.err;
    EXPECT_TRUE(fs::exists(folder_ / name));
  }
}

// An unfinished file is removed, and the earlier one stays.
TEST_F(CliExport, AFullDiskLeavesNoHalfFile) {
  const std::string before = exported("c.stl");
  const Outcome made = run("export -q /dev/null --alpha 1 -o '" + path("c.stl") + "'");
  EXPECT_NE(made.code, 0);
  rlimit limit{}, small{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &limit), 0);
  small = limit;
  small.rlim_cur = 20000;
  ::signal(SIGXFSZ, SIG_IGN);  // children inherit this
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const Outcome full =
      run("export -q " + std::string(kCrambin) + " --alpha 3 -o '" + path("c.stl") + "'");
  const Outcome script =
      run("export -q " + std::string(kCrambin) + " --alpha 3 -o '" + path("c.pml") + "'");
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
  EXPECT_EQ(full.code, 5) << full.err;
  EXPECT_EQ(script.code, 5) << script.err;
  EXPECT_EQ(contents(folder_ / "c.stl"), before);
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(folder_)) {
    const std::string name = entry.path().filename();
    EXPECT_FALSE(name.ends_with(".tmp")) << name;
    files += name.starts_with("c");
  }
  EXPECT_EQ(files, 2u);  // c.stl and cube.xyzr
}

TEST_F(CliExport, AScriptsFilesDoNotReplaceTheMolecule) {
  fs::copy_file(kCrambin, folder_ / "x-balls.pqr");
  const Outcome made =
      run("export '" + path("x-balls.pqr") + "' --format pdb --alpha 1 -o '" + path("x.pml") + "'");
  EXPECT_EQ(made.code, 2);
  EXPECT_TRUE(contains(made.err, "would replace")) << made.err;
}

}  // namespace
}  // namespace alphascope::testing
