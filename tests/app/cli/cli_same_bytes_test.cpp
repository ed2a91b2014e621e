// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that a command always writes the same bytes, at any speed and with any number of threads.
// Also tests results of files with unusual names.
#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/read/read_molecule.hpp"
#include "core/write/csv.hpp"
#include "tests/app/cli/cli_fixture.hpp"

namespace alphascope::testing {
namespace {

const std::string kCrambin = ALPHASCOPE_SOURCE_DIR "/resources/molecules/1crn.pdb";

class CliSameBytes : public Cli {
 protected:
  // All files that the command writes, with standard output and error. NAME in the arguments stands
  // for a file of its own.
  std::map<std::string, std::string> written(std::string arguments) const {
    const fs::path into = folder_ / "into";
    fs::remove_all(into);
    fs::create_directory(into);
    for (std::size_t at; (at = arguments.find("INTO/")) != arguments.npos;) {
      arguments.replace(at, 4, into.string());
    }
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 0) << arguments << "\n" << outcome.err;
    std::map<std::string, std::string> all{{"out", outcome.out}, {"err", outcome.err}};
    for (const auto& entry : fs::directory_iterator(into)) {
      all[entry.path().filename()] = contents(entry.path());
    }
    return all;
  }
};

TEST_F(CliSameBytes, NoTimesLeavesOutAllThatDependsOnTimeAndThreads) {
  const std::string file = " '" + kCrambin + "' --no-times ", two = "'" + cube_.string() + "'";
  const struct {
    std::string arguments;
    bool threads;
  } cases[] = {
      {"info" + file + "--json INTO/j --csv INTO/c", false},
      {"info" + file + two, false},
      {"compute --alpha 1.4 --solvent 1.2" + file + "--json INTO/j --csv INTO/c --out INTO/o",
       true},
      {"compute --alpha 1.4 -v --engine tuples-cpu" + file, true},
      {"compute --alpha 1.4" + file + two + " --json INTO/j --csv INTO/c", true},
      {"measure --per residue --solvent 1.4" + file + "--json INTO/j --csv INTO/c", true},
      {"cavities" + file + "--json INTO/j --csv INTO/c --lives INTO/l --spheres INTO/s.pqr", true},
      {"cavities --solvent 1.2,1.4" + file + "--json INTO/j --csv INTO/c", true},
      {"channel --cavity 1" + file + "--json INTO/j --csv INTO/c", true},
      {"channel" + file + "--json INTO/j --csv INTO/c", true},
      {"export --alpha 1.4 -o INTO/x.csv" + file, true},
      {"export --alpha 1.4 -o INTO/x.vtp" + file, true},
      {"explain --simplex 0,1 --alpha 1" + file + "--json INTO/j", false},
      {"steps --ball 5 --alpha 1" + file + "--json INTO/j", false},
      {"verify --alpha 0,1.4" + file + "--json INTO/j", true}};
  for (const auto& c : cases) {
    const auto first = written(c.arguments + (c.threads ? " --threads 1" : ""));
    const auto second = written(c.arguments + (c.threads ? " --threads 2" : ""));
    ASSERT_EQ(first.size(), second.size());
    for (const auto& [name, text] : first) {
      if (name != "err" || !contains(c.arguments, "-v")) {
        EXPECT_EQ(text, second.at(name)) << c.arguments << ": " << name;
      }
      EXPECT_FALSE(contains(text, "_ms\"") || contains(text, "threads")) << name << "\n" << text;
    }
  }
  if (kDrawsPictures) {
    const std::string draw = "screenshot --alpha 1 --size 64x64 -o INTO/p.png" + file;
    EXPECT_EQ(written(draw + "--threads 1").at("p.png"), written(draw + "--threads=2").at("p.png"));
  }
  // Times are the result of bench.
  EXPECT_EQ(run("bench --alpha 1 --no-times" + file).code, 2);
  // Without the option times are written.
  EXPECT_TRUE(contains(run("compute --alpha 1 --json - '" + kCrambin + "'").out, "\"timings_ms\""));
}

TEST_F(CliSameBytes, QuietPrintsNoTimes) {
  const std::string file = " -q '" + kCrambin + "'";
  for (const std::string& arguments :
       {"info" + file, "compute --alpha 1" + file,
        "compute --alpha 1 '" + cube_.string() + "'" + file, "measure" + file, "cavities" + file,
        "channel --cavity 1" + file, "explain --simplex 0,1" + file,
        "steps --ball 5 --alpha 1" + file, "verify --alpha 1" + file,
        "export --alpha 1 -o '" + (folder_ / "x.stl").string() + "'" + file}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 0) << arguments << outcome.err;
    EXPECT_EQ(outcome.err, "") << arguments;
    for (const char* time : {" ms\n", " ms ", "\ntime ", "\nTime ", "\nopened in ", "  time\n"}) {
      EXPECT_FALSE(contains(outcome.out, time)) << arguments << "\n" << outcome.out;
    }
  }
}

TEST_F(CliSameBytes, TheLatticeIsThatOfTheBallsThatWereUsed) {
  // Crambin needs three digits, a solvent radius of 1.2005 Å four.
  const std::string file = " '" + kCrambin + "' --solvent 1.2005 ";
  for (const std::string command : {"compute --alpha 0", "measure", "cavities"}) {
    const json result = json::parse(run(command + file + "--json -").out);
    EXPECT_EQ(result["input"]["lattice_unit_angstrom"], 0.0001) << command;
    const auto rows = csv_rows(run(command + file + "--csv -").out);
    ASSERT_FALSE(rows.empty());
    EXPECT_EQ(rows[0].at("lattice_unit_angstrom"), "0.0001") << command;
  }
  for (const std::string command :
       {"explain --simplex 0,1", "steps --ball 0 --alpha 1", "verify --alpha 1"}) {
    const json result = json::parse(run(command + file + "--json -").out);
    EXPECT_EQ(result["input"]["lattice_unit_angstrom"], 0.0001) << command;
  }
  const json models = json::parse(run("verify --alpha 1 --model all" + file + "--json -").out);
  EXPECT_EQ(models["results"][0]["input"]["lattice_unit_angstrom"], 0.0001);
  const std::string lives = run("cavities" + file + "--lives -").out;
  EXPECT_TRUE(contains(lives, "# lattice_unit_angstrom: 0.0001\n")) << lives.substr(0, 2000);
  // Without the option it is the file's own.
  const json plain = json::parse(run("info '" + kCrambin + "' --json -").out);
  EXPECT_EQ(plain["input"]["lattice_unit_angstrom"], 0.001);
}

// Chains and residues with blanks, quotes, semicolons and formulas of spreadsheets.
constexpr const char* kEvil =
    "data_x\n_struct.title '=HYPERLINK(\"http://x\",\"y\")'\nloop_\n"
    "_atom_site.group_PDB\n_atom_site.id\n_atom_site.type_symbol\n_atom_site.label_atom_id\n"
    "_atom_site.label_comp_id\n_atom_site.label_asym_id\n_atom_site.label_seq_id\n"
    "_atom_site.pdbx_PDB_ins_code\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n"
    "_atom_site.auth_asym_id\n"
    "ATOM 1 C CA ALA '=1+1; close all' 1 ; 0.0 0.0 0.0 '=1+1; close all'\n"
    "ATOM 2 N '+N' 'x y' '-B\"; delete atoms; \"' 2 ? 3.0 0.0 0.0 '-B\"; delete atoms; \"'\n"
    "ATOM 3 C '@O' '<s>' A 3 ? 0.0 3.0 0.0 A\n"
    "ATOM 4 O 'O;q' ALA A 4 ? 0.0 0.0 3.0 A\n";

TEST_F(CliSameBytes, NamesWithBlanksComeBackFromPqr) {
  const std::string file = "'" + write("evil.cif", kEvil).string() + "' ";
  const fs::path pqr = folder_ / "e.pqr", xyzr = folder_ / "e.xyzr";
  const json whole = compute_json(file + "--alpha 2 --radii bondi");
  for (const fs::path& out : {pqr, xyzr}) {
    const Outcome made =
        run("export --alpha 2 --radii bondi " + file + "-o '" + out.string() + "'");
    ASSERT_EQ(made.code, 0) << made.err;
    EXPECT_EQ(compute_json("'" + out.string() + "' --alpha 2 --radii file")["hash"], whole["hash"]);
  }
  const Molecule again = read_molecule(pqr);
  ASSERT_EQ(again.atoms.size(), 4u);
  EXPECT_EQ(again.text(again.atoms[0].chain), "=1+1;_close_all");
  EXPECT_EQ(again.text(again.atoms[1].residue_name), "x_y");
  EXPECT_EQ(again.text(again.atoms[1].name), "+N");
  EXPECT_EQ(again.atoms[3].residue_number, 4);
}

TEST_F(CliSameBytes, NoNameIsACommandInAScript) {
  const std::string file = "'" + write("evil.cif", kEvil).string() + "' ";
  for (const std::string ending : {"cxc", "pml", "tcl"}) {
    const fs::path out = folder_ / ("e." + ending);
    ASSERT_EQ(run("export --colours chain --alpha 2 " + file + "-o '" + out.string() + "'").code,
              0);
    std::istringstream lines(contents(out));
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("#")) continue;
      EXPECT_FALSE(contains(line, "close all") || contains(line, "delete")) << line;
    }
  }
  // In PyMOL a command begins behind a semicolon. In Python a comment ends with its line.
  EXPECT_TRUE(contents(folder_ / "e.pml").starts_with("python\n# "));
}

TEST_F(CliSameBytes, CellsThatSpreadsheetsWouldComputeAreTexts) {
  const std::string file = "'" + write("evil.cif", kEvil).string() + "' ";
  const auto info = csv_rows(run("info " + file + "--csv -").out);
  ASSERT_EQ(info.size(), 1u);
  EXPECT_EQ(info[0].at("title"), "'=HYPERLINK(\"http://x\",\"y\")");
  EXPECT_EQ(plain_cell(info[0].at("title")), "=HYPERLINK(\"http://x\",\"y\")");
  const auto chains = csv_rows(run("measure --per chain " + file + "--csv -").out);
  ASSERT_EQ(chains.size(), 3u);
  for (const auto& row : chains) {
    for (const auto& [name, cell] : row) {
      EXPECT_FALSE(cell.starts_with("=") || cell.starts_with("@")) << name << " " << cell;
    }
  }
  const auto moved = csv_rows(run("measure --alpha=-0.5 '" + cube_.string() + "' --csv -").out);
  EXPECT_EQ(moved.at(0).at("alpha_angstrom2"), "-0.5") << "a number stays one";
}

TEST_F(CliSameBytes, NamesThatAreNoUtf8AreWholeInJson) {
  const fs::path odd = write("\xE4\xF6.xyzr", "0 0 0 1\n");
  const json result = json::parse(run("info '" + odd.string() + "' --json -").out);
  std::string hexadecimal;
  for (const char c : odd.string()) {
    char digits[4];
    std::snprintf(digits, sizeof digits, "%02x", static_cast<unsigned char>(c));
    hexadecimal += digits;
  }
  EXPECT_EQ(result["input"]["file"], json({{"bytes", hexadecimal}}));
  const json many = json::parse(run("info '" + odd.string() + "' '\xFF' --json -").out);
  EXPECT_EQ(many["results"][0]["input"]["file"]["bytes"], hexadecimal);
  EXPECT_EQ(many["failed"][0]["file"]["bytes"], "ff");
}

}  // namespace
}  // namespace alphascope::testing
