// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the files that alphascope-cli cavities writes for other programs. Reads them back as those
// programs would. Also tests cavities with several radii side by side.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/read/read_molecule.hpp"
#include "core/write/csv.hpp"
#include "tests/app/cli/cli_fixture.hpp"

namespace alphascope::testing {
namespace {

const char* const kHaemoglobin = ALPHASCOPE_SOURCE_DIR "/resources/molecules/4hhb.pdb.gz";
const char* const kCrambin = ALPHASCOPE_SOURCE_DIR "/resources/molecules/1crn.pdb";
const char* const kTwoVoids = ALPHASCOPE_SOURCE_DIR "/tests/data/cavities/traps/two_voids.xyzr";

class CliCavityExports : public Cli {
 protected:
  json cavities(const std::string& arguments) const {
    const Outcome found = run("cavities -q --json - " + arguments);
    EXPECT_EQ(found.code, 0) << found.err;
    return found.code == 0 ? json::parse(found.out) : json();
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
};

TEST_F(CliCavityExports, SpheresAreReadBackAndTouchNoAtom) {
  const Outcome found = run("cavities -q '" + std::string(kTwoVoids) + "' --solvent 0 --spheres '" +
                            path("spheres.pqr") + "'");
  ASSERT_EQ(found.code, 0) << found.err;
  const Molecule spheres = read_molecule(folder_ / "spheres.pqr"), balls = read_molecule(kTwoVoids);
  ASSERT_TRUE(spheres.has_file_radii);
  std::set<int> residues;
  const auto place = [](const Molecule& of, const LatticePoint& p, int axis) {
    return of.lattice.angstrom(axis == 0 ? p.x : axis == 1 ? p.y : p.z);
  };
  for (const Atom& s : spheres.atoms) {
    residues.insert(s.residue_number);
    double least = 1e300;
    for (const Atom& b : balls.atoms) {
      double square = 0;
      for (int axis = 0; axis < 3; ++axis) {
        const double d = place(spheres, s.position, axis) - place(balls, b.position, axis);
        square += d * d;
      }
      least = std::min(least, std::sqrt(square) - balls.lattice.angstrom(b.file_radius));
    }
    const double radius = spheres.lattice.angstrom(s.file_radius);
    EXPECT_LE(radius, least + 1e-9);
    EXPECT_GT(radius, least - 0.0011);
  }
  EXPECT_EQ(residues, (std::set<int>{1, 2}));
  const std::string text = contents(folder_ / "spheres.pqr");
  EXPECT_TRUE(contains(text, "REMARK   3 sha256 ")) << text.substr(0, 500);
  EXPECT_TRUE(contains(text, "REMARK   3 choices not comparable with CASTp"));
}

// The file of lives has a line for each cavity of every alpha, even if none exists at the requested
// alpha.
TEST_F(CliCavityExports, LivesAreOfAllAlphasAndThoseOfTheTable) {
  const auto lines_of = [&](const std::string& alpha) {
    const Outcome found = run("cavities -q '" + std::string(kCrambin) + "' --solvent 0.6 --alpha " +
                              alpha + " --lives '" + path("lives.csv") + "'");
    EXPECT_EQ(found.code, 0) << found.err;
    std::set<std::string> lines;
    std::istringstream text(contents(folder_ / "lives.csv"));
    for (std::string line; std::getline(text, line);) {
      if (!line.starts_with("#")) lines.insert(line);
    }
    return lines;
  };
  const std::set<std::string> lines = lines_of("0");
  EXPECT_TRUE(
      lines.contains("born_alpha_angstrom2,closed_alpha_angstrom2,gone_alpha_angstrom2,name"));
  EXPECT_GT(lines.size(), 100u);
  EXPECT_TRUE(contains(contents(folder_ / "lives.csv"), "# sha256: "));
  const json found = cavities("'" + std::string(kCrambin) + "' --solvent 0.6");
  ASSERT_GT(found["cavities"].size(), 3u);
  for (const json& cavity : found["cavities"]) {
    std::string line;
    for (const char* alpha : {"born", "closed", "gone"}) {
      const json& value = cavity[alpha + std::string("_alpha_angstrom2")];
      line += (value.is_null() ? "" : all_digits(value.get<double>())) + ",";
    }
    EXPECT_TRUE(lines.contains(line + cavity["name"].get<std::string>())) << line;
  }
  EXPECT_EQ(lines_of("1000"), lines);
  const Outcome two = run("cavities '" + std::string(kCrambin) + "' '" + kTwoVoids + "' --lives '" +
                          path("two.csv") + "'");
  EXPECT_EQ(two.code, 2);
  EXPECT_TRUE(contains(two.err, "one file")) << two.err;
  EXPECT_FALSE(fs::exists(folder_ / "two.csv"));
}

// Reads the two chunks of a GLB file.
struct Glb {
  json head;
  std::string data;
};
Glb read_glb(const std::string& bytes) {
  const auto word = [&](std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
  };
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_EQ(word(4), 2u);
  EXPECT_EQ(word(8), bytes.size());
  const std::size_t size = word(12);
  EXPECT_EQ(size % 4, 0u);
  Glb glb{json::parse(bytes.substr(20, size)), ""};
  if (20 + size == bytes.size()) return glb;
  EXPECT_EQ(word(20 + size), bytes.size() - 28 - size);
  glb.data = bytes.substr(28 + size);
  return glb;
}

TEST_F(CliCavityExports, SurfacesAreGlbWithAClosedOneForEachVoid) {
  const json listed = cavities(std::string(kHaemoglobin) + " --surface '" + path("s.glb") + "'");
  const Glb glb = read_glb(contents(folder_ / "s.glb"));
  ASSERT_EQ(glb.head["meshes"].size(), listed["cavities"].size());
  EXPECT_EQ(glb.head["scenes"][0]["nodes"].size(), glb.head["nodes"].size());
  const json& header = glb.head["asset"]["extras"]["header"];
  EXPECT_TRUE(std::any_of(header.begin(), header.end(), [](const json& entry) {
    return entry[0] == "sha256";
  })) << header;
  std::size_t closed = 0;
  for (std::size_t m = 0; m < glb.head["meshes"].size(); ++m) {
    const json& primitive = glb.head["meshes"][m]["primitives"][0];
    const json& indices = glb.head["accessors"][primitive["indices"].get<std::size_t>()];
    const json& points =
        glb.head["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()];
    const json& view = glb.head["bufferViews"][indices["bufferView"].get<std::size_t>()];
    std::vector<std::uint32_t> list(indices["count"].get<std::size_t>());
    ASSERT_EQ(view["byteLength"], 4 * list.size());
    std::memcpy(list.data(), glb.data.data() + view["byteOffset"].get<std::size_t>(),
                4 * list.size());
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
    for (std::size_t n = 0; n < list.size(); ++n) {
      const std::uint32_t a = list[n], b = list[n % 3 == 2 ? n - 2 : n + 1];
      ASSERT_LT(a, points["count"].get<std::uint32_t>());
      balance[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
    const bool is_closed = std::all_of(balance.begin(), balance.end(),
                                       [](const auto& side) { return side.second == 0; });
    EXPECT_EQ(is_closed, listed["cavities"][m]["kind"] == "void") << m;
    closed += is_closed;
  }
  EXPECT_EQ(closed, listed["counts"]["voids"]);
}

TEST_F(CliCavityExports, OfNoCavityAFileIsStillRead) {
  const std::string flat = write("flat.xyzr", "0 0 0 1\n3 0 0 1\n0 3 0 1\n").string();
  const Outcome found = run("cavities '" + flat + "' --surface '" + path("s.glb") +
                            "' --spheres '" + path("s.pqr") + "'");
  EXPECT_EQ(found.code, 0) << found.err;
  const Glb glb = read_glb(contents(folder_ / "s.glb"));
  EXPECT_FALSE(glb.head.contains("nodes"));
  EXPECT_TRUE(contains(contents(folder_ / "s.pqr"), "END\n"));
}

// Residues such as "A:87" of the lines of a PDB file, by serial number.
std::map<int, std::string> residues_by_serial(const std::string& pdb) {
  std::map<int, std::string> residues;
  std::istringstream lines(pdb);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("ATOM")) continue;
    residues[std::stoi(line.substr(6, 5))] =
        line.substr(21, 1) + ":" + std::to_string(std::stoi(line.substr(22, 4)));
  }
  return residues;
}

// Residues of a cavity in JSON, such as "A:87".
std::set<std::string> residues_of(const json& cavity) {
  std::set<std::string> residues;
  for (const json& of : cavity["residues"]) {
    const std::string address = of["residue"];  // "A:HIS 87"
    residues.insert(address.substr(0, 2) + address.substr(address.rfind(' ') + 1));
  }
  return residues;
}

TEST_F(CliCavityExports, ScriptsNameTheLiningOfEachCavity) {
  const std::string file = path("4hhb.pdb");
  ASSERT_EQ(std::system(("zcat " + std::string(kHaemoglobin) + " > '" + file + "'").c_str()), 0);
  const json listed = cavities(file + " --min-volume 20 --script '" + path("show.pml") + "'");
  ASSERT_EQ(run("cavities -q " + file + " --min-volume 20 --script '" + path("show.cxc") +
                "' --spheres '" + path("s p.pqr") + "'")
                .code,
            0);
  const auto by_serial = residues_by_serial(contents(file));
  const std::string pml = contents(folder_ / "show.pml"), cxc = contents(folder_ / "show.cxc");
  ASSERT_GT(listed["cavities"].size(), 5u);
  EXPECT_TRUE(contains(cxc, "open '" + path("s p.pqr") + "' format pdb id 2\n")) << cxc;
  for (const json& cavity : listed["cavities"]) {
    const std::string number = std::to_string(cavity["id"].get<int>());
    std::set<std::string> in_pymol, in_chimerax;
    std::istringstream lines(pml);
    for (std::string line; std::getline(lines, line);) {
      if (!line.starts_with("cmd.select('cavity_" + number + "', 'cavity_")) continue;
      std::istringstream ids(line.substr(line.find(" id ") + 4));
      for (int id = 0; ids >> id; ids.get()) in_pymol.insert(by_serial.at(id));
    }
    EXPECT_EQ(in_pymol, residues_of(cavity));
    lines = std::istringstream(cxc);
    for (std::string line; std::getline(lines, line);) {
      const std::string start = "name cavity" + number + " #1/";
      if (!line.starts_with(start)) continue;
      std::istringstream parts(line.substr(start.size()));
      for (std::string part; std::getline(parts, part, '/');) {
        std::istringstream chain(part);
        std::string residue, name;
        std::getline(chain, name, ':');
        while (std::getline(chain, residue, ':')) {
          in_chimerax.insert(name + ":" + residue.substr(0, residue.find('@')));
        }
      }
    }
    EXPECT_EQ(in_chimerax, residues_of(cavity));
  }
}

// Each command with its options, as in both programs' user guides. ChimeraX has no format "pqr":
// its PDB reader reads such files (user/commands/open.html). PyMOL 2.5 ran such a script.
TEST_F(CliCavityExports, ScriptsHaveOnlyCommandsThatTheProgramsKnow) {
  const std::string file(kHaemoglobin);
  for (const char* script : {"show.cxc", "show.pml"}) {
    ASSERT_EQ(run("cavities -q " + file + " --min-volume 20 --script '" + path(script) +
                  "' --spheres '" + path("s.pqr") + "' --surface '" + path("s.glb") + "'")
                  .code,
              0);
  }
  const std::string spec = R"(#\d(:\d+)?|cavity\d+)", name = "'[^']+'";
  const std::regex chimerax("#.*|open " + name + "( format pdb)? id [123]|hide #1 atoms|" +
                            "cartoon #1|color (" + spec + ") #[0-9a-f]{6}|show (" + spec +
                            ") atoms|style (" + spec + ") (stick|sphere)|" +
                            "transparency #2 50 target a|view");
  const std::regex lining(R"(name cavity\d+ #1/[A-Z]:-?\d+@.*)");
  std::istringstream lines(contents(folder_ / "show.cxc"));
  std::set<std::string> seen;
  for (std::string line; std::getline(lines, line);) {
    // A line of atoms is long, and std::regex recurses.
    EXPECT_TRUE(line.starts_with("name ") ? std::regex_match(line.substr(0, 60), lining)
                                          : std::regex_match(line, chimerax))
        << line;
    seen.insert(line.substr(0, line.find(' ')));
  }
  for (const char* command : {"open", "name", "color", "transparency"}) {
    EXPECT_TRUE(seen.contains(command)) << command;
  }
  const std::set<std::string> pymol = {"load",  "hide",    "show", "color",    "select",
                                       "alter", "rebuild", "set",  "deselect", "zoom"};
  lines = std::istringstream(contents(folder_ / "show.pml"));
  const std::set<std::string> around = {"python", "import os", "from pymol import cmd",
                                        "python end"};
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("#") || around.contains(line)) continue;
    ASSERT_TRUE(line.starts_with("cmd.") && line.ends_with(")")) << line;
    EXPECT_TRUE(pymol.contains(line.substr(4, line.find('(') - 4))) << line;
  }
}

// The file name would be a command if it were not quoted.
TEST_F(CliCavityExports, HostileFileNamesStayNames) {
  const std::string names[] = {"two words.pdb", "it's.pdb", "line\nopen evil.pdb", "a\"b'c.pdb"};
  for (const std::string& name : names) {
    fs::copy_file(kCrambin, folder_ / name);
    const std::string shell = [&] {  // quoted for the shell
      std::string text = "'";
      for (const char c : (folder_ / name).string())
        text += c == '\'' ? "'\\''" : std::string(1, c);
      return text + "'";
    }();
    const Outcome pymol = run("cavities -q " + shell + " --script '" + path("s.pml") + "'");
    ASSERT_EQ(pymol.code, 0) << pymol.err;
    const std::string pml = contents(folder_ / "s.pml");
    const std::size_t begin = pml.find("fsdecode(b'") + 11;
    std::string decoded;
    for (std::size_t k = begin; pml.at(k) != '\''; ++k) {
      if (pml[k] != '\\') {
        decoded += pml[k];
      } else {
        decoded += static_cast<char>(std::stoi(pml.substr(k + 2, 2), nullptr, 16));
        k += 3;
      }
    }
    EXPECT_EQ(decoded, (folder_ / name).string());
    EXPECT_EQ(pml.find("\nopen evil"), pml.npos);
    const Outcome chimerax = run("cavities -q " + shell + " --script '" + path("s.cxc") + "'");
    const bool sayable = name == names[0] || name == names[1];
    EXPECT_EQ(chimerax.code, sayable ? 0 : 2) << name << chimerax.err;
    if (sayable) {
      const char quote = name == names[1] ? '"' : '\'';
      EXPECT_TRUE(contains(contents(folder_ / "s.cxc"),
                           "\nopen " + (quote + (folder_ / name).string()) + quote + " id 1\n"));
    } else {
      EXPECT_TRUE(contains(chimerax.err, ".pml")) << chimerax.err;
    }
    fs::remove(folder_ / "s.cxc");
  }
}

// The way out of a cavity of crambin, as in the samples of its JSON file.
TEST_F(CliCavityExports, AChannelIsWrittenForOtherProgramsToo) {
  const Outcome found =
      run("channel -q '" + std::string(kCrambin) + "' --cavity 1 --json - --spheres '" +
          path("c.pqr") + "' --surface '" + path("c.glb") + "' --script '" + path("c.cxc") + "'");
  ASSERT_EQ(found.code, 0) << found.err;
  const json channel = json::parse(found.out);
  const Molecule spheres = read_molecule(folder_ / "c.pqr");
  std::size_t passed = 0;
  for (const json& sample : channel["samples"]) {
    const double radius = sample["radius_angstrom"];
    if (radius < 0.002) continue;
    ASSERT_LT(passed, spheres.atoms.size());
    const Atom& atom = spheres.atoms[passed++];
    const LatticePoint& p = atom.position;
    const double written = spheres.lattice.angstrom(atom.file_radius);
    EXPECT_NEAR(spheres.lattice.angstrom(p.x), sample["position_angstrom"][0], 0.00051);
    EXPECT_NEAR(spheres.lattice.angstrom(p.z), sample["position_angstrom"][2], 0.00051);
    EXPECT_LE(written, radius) << "its place is rounded: it must not cut into an atom";
    EXPECT_GT(written, radius - 0.0019);
  }
  EXPECT_EQ(passed, spheres.atoms.size());
  EXPECT_GT(passed, 20u);
  EXPECT_TRUE(contains(contents(folder_ / "c.pqr"), "  SPH CHN C    1 "));
  EXPECT_TRUE(contains(contents(folder_ / "c.pqr"), "REMARK   3 widest_angstrom "));
  const Glb glb = read_glb(contents(folder_ / "c.glb"));
  ASSERT_EQ(glb.head["meshes"].size(), 1u);
  EXPECT_EQ(glb.head["meshes"][0]["name"], "channel");
  const std::string cxc = contents(folder_ / "c.cxc");
  EXPECT_TRUE(contains(cxc, "\nname channel1 #1/A:")) << cxc;
  EXPECT_TRUE(contains(cxc, "\nopen '" + path("c.glb") + "' id 3\n")) << cxc;
  for (const json& touching : channel["bottleneck"]["touching"]) {
    const std::string atom = touching["atom"];  // "A:CYS 3:SG"
    const std::string residue =
        atom.substr(atom.find(' ') + 1, atom.rfind(':') - atom.find(' ') - 1);
    EXPECT_TRUE(contains(cxc, ":" + residue + "@")) << atom;
  }
}

TEST_F(CliCavityExports, WhatCannotBeWrittenIsSaidBeforehand) {
  const std::string file = kCrambin;
  for (const char* wrong : {"--surface a.obj", "--script a.txt", "--script -", "--spheres a.pdb"}) {
    const Outcome found = run("channel " + file + " --cavity 1 " + wrong);
    EXPECT_EQ(found.code, 2) << wrong << found.err;
  }
  for (const char* wrong :
       {"--surface a.obj", "--script a.txt", "--script -", "--spheres s.pqr --solvent 1.2,1.4",
        "--surface s.ply --radii castp,bondi", "--script s.pml --model all"}) {
    const Outcome found = run("cavities " + file + " " + wrong);
    EXPECT_EQ(found.code, 2) << wrong << found.err;
  }
  EXPECT_EQ(run("cavities " + std::string(kTwoVoids) + " --script '" + path("s.pml") + "'").code,
            2);
  EXPECT_FALSE(fs::exists(folder_ / "s.pml"));
  EXPECT_EQ(run("cavities " + file + " --surface /dev/full/s.glb").code, 5);
}

TEST_F(CliCavityExports, SideBySideCavitiesAreMatched) {
  const std::string file = kHaemoglobin;
  const json found = cavities(file + " --solvent 1.4,1.4,1.2 --radii castp,bondi");
  ASSERT_EQ(found["variants"].size(), 6u);
  EXPECT_EQ(found["variants"][0]["variant"], "castp 1.4");
  EXPECT_EQ(found["variants"][5]["variant"], "bondi 1.2");
  EXPECT_EQ(found["variants"][0]["cavities"], cavities(file)["cavities"]);
  const json alone = cavities(file + " --radii bondi");
  EXPECT_EQ(found["variants"][3]["counts"], alone["counts"]);
  std::size_t same = 0, other_volume = 0;
  for (const json& cavity : found["side_by_side"]) {
    const json& in = cavity["in"];
    EXPECT_EQ(in[0]["same"], true);
    EXPECT_EQ(in[0]["id"], cavity["id"]);
    EXPECT_EQ(in[1], in[0]);  // the same radii
    same += in[2]["same"] == true;
    other_volume +=
        in[3]["same"] == true && in[3]["volume_sa_angstrom3"] != in[0]["volume_sa_angstrom3"];
    // Checks the spread: the difference of the largest and least volumes, as a share of the
    // largest.
    double least = in[0]["volume_sa_angstrom3"], most = least;
    for (const json& one : in) {
      if (one["same"] != true) continue;
      least = std::min<double>(least, one["volume_sa_angstrom3"]);
      most = std::max<double>(most, one["volume_sa_angstrom3"]);
    }
    if (most > 0) {
      EXPECT_NEAR(cavity["spread_percent"], 100 * (most - least) / most, 1e-9);
    }
    if (in[2]["same"] == true) {
      EXPECT_GT(cavity["spread_percent"], 0);
    }
  }
  EXPECT_GT(same, 40u);
  EXPECT_GT(other_volume, 20u);
  // The large cavity grows as the probe shrinks.
  EXPECT_GT(found["side_by_side"][0]["in"][2]["volume_sa_angstrom3"],
            found["side_by_side"][0]["in"][0]["volume_sa_angstrom3"]);
  const Outcome rows = run("cavities -q --csv - " + file + " --solvent 1.4,1.2");
  std::size_t largest = 0;
  for (const auto& row : csv_rows(rows.out)) largest += row.at("first_id") == "1";
  EXPECT_EQ(largest, 2u);
  const Outcome text = run("cavities " + file + " --solvent 1.4,1.6 --show 3");
  EXPECT_TRUE(contains(text.out, "spread")) << text.out;
}

// A radius of four decimals refines the lattice, but cavities keep their identities.
TEST_F(CliCavityExports, CavitiesAreMatchedAcrossLattices) {
  const json found = cavities(std::string(kHaemoglobin) + " --solvent 1.4,1.2005");
  std::size_t same = 0, gone = 0;
  for (const json& cavity : found["side_by_side"]) {
    same += cavity["in"][1]["same"] == true;
    gone += cavity["in"][1]["id"].is_null();
  }
  EXPECT_EQ(same, 59u);
  EXPECT_EQ(gone, 0u);
}

TEST_F(CliCavityExports, SmallCavitiesAreCountedButNotListed) {
  const json all = cavities(kHaemoglobin);
  const json some = cavities(std::string(kHaemoglobin) + " --min-volume 100");
  EXPECT_EQ(some["counts"], all["counts"]);
  ASSERT_EQ(some["cavities"].size(), 5u);
  for (std::size_t row = 0; row < 5; ++row) EXPECT_EQ(some["cavities"][row], all["cavities"][row]);
  EXPECT_EQ(run("cavities " + std::string(kHaemoglobin) + " --min-volume much").code, 2);
}

// The haems are not part of the body. Each lies in its own pocket.
TEST_F(CliCavityExports, HaemPocketsHoldTheHaems) {
  std::set<std::string> haems;
  const json all = cavities(kHaemoglobin);
  for (const json& cavity : all["cavities"]) {
    for (const json& held : cavity["holds"]) {
      if (held["kind"] == "ligand") haems.insert(held["residue"]);
    }
    EXPECT_GE(cavity["depth_angstrom"], 0);
    // A pocket whose lining atoms are all corners of mouths has no depth either.
    if (cavity["kind"] == "void") {
      EXPECT_EQ(cavity["depth_angstrom"], 0.0);
    }
    EXPECT_GT(cavity["gone_alpha_angstrom2"], 0);
    EXPECT_LE(cavity["born_alpha_angstrom2"].is_null()
                  ? -1e9
                  : cavity["born_alpha_angstrom2"].get<double>(),
              0);
  }
  for (const char* haem : {"A:HEM 142", "B:HEM 148", "C:HEM 142", "D:HEM 148"}) {
    EXPECT_TRUE(haems.count(haem)) << haem;
  }
}

}  // namespace
}  // namespace alphascope::testing
