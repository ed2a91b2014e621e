// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the real alphascope-cli on small files: results, exit codes, and messages for bad input.
#include "core/geometry/lattice_alpha.hpp"
#include "tests/app/cli/cli_fixture.hpp"
#include "tests/support/molecules.hpp"

namespace alphascope::testing {
namespace {

TEST_F(Cli, HelpHasExamplesAndExitCodes) {
  const Outcome outcome = run("--help");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_TRUE(contains(outcome.out, "Examples:"));
  EXPECT_TRUE(contains(outcome.out, "Exit codes:"));
  for (const char* command : {"info", "compute", "verify", "bench", "screenshot", "frames"}) {
    EXPECT_TRUE(contains(outcome.out, command));
    EXPECT_EQ(run(std::string(command) + " --help").code, 0);
  }
  EXPECT_EQ(run("--version").code, 0);
}

TEST_F(Cli, WrongUsageIsCode2) {
  for (const std::string& arguments :
       {std::string(""), std::string("frobnicate"), "compute '" + cube_.string() + "'",
        "compute '" + cube_.string() + "' --alpha banana",
        "compute '" + cube_.string() + "' --alpha inf",
        "compute '" + cube_.string() + "' --alpha 1 --solvent -1",
        "compute '" + cube_.string() + "' --alpha 1 --engine warp",
        "compute '" + cube_.string() + "' --alpha 1 --threads -3",
        "compute '" + cube_.string() + "' --alpha 1 --engine cpu --no-edge-optimisation",
        "compute '" + cube_.string() + "' --alpha 1 --engine tuples-cpu --tuple-grid 7",
        "compute '" + cube_.string() + "' --alpha 1 --radii nosuchset",
        "compute '" + cube_.string() + "' --alpha 1 --model 0",
        "compute '" + cube_.string() + "' --alpha 1 --model 9",
        "verify '" + cube_.string() + "' --alpha 1 --engine cgal"}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments << "\n" << outcome.err;
    EXPECT_FALSE(outcome.err.empty()) << arguments;
  }
}

TEST_F(Cli, WrongChoicesNameTheFileAndWhatThereIs) {
  const std::string file = ALPHASCOPE_SOURCE_DIR "/resources/molecules/1crn.pdb";
  const struct {
    const char *option, *said;
  } cases[] = {{"--chain Z", "1crn.pdb: there is no chain \"Z\": the file has A."},
               {"--without-chain A,Q", "there is no chain \"Q\""},
               {"--model 2", "1crn.pdb: there is no model 2: the file has 1."},
               {"--assembly 9", "1crn.pdb: there is no assembly 9: the file has 1."},
               {"--radii file", "1crn.pdb: the file has no radii of its own"},
               {"--select 'chain'", "--select \"chain\", column 6: expected a chain name"}};
  for (const auto& c : cases) {
    const Outcome outcome = run("info '" + file + "' " + c.option);
    EXPECT_EQ(outcome.code, 2) << c.option;
    EXPECT_TRUE(contains(outcome.err, c.said)) << outcome.err;
  }
  EXPECT_TRUE(contains(run("info '" + cube_.string() + "' --chain A").err, "one without a name"));
}

TEST_F(Cli, ASelectionOfNothingIsAnError) {
  const std::string file = ALPHASCOPE_SOURCE_DIR "/resources/molecules/1crn.pdb";
  const struct {
    const char *options, *said;
  } cases[] = {{"--select 'altloc Z'", "atoms not selected. Change --select."},
               {"--select 'element Zn'", "Change --select."},
               {"--select none", "1crn.pdb: no atom is left: dropped 327 atoms not selected."},
               {"--select 'chain A and chain B'", "Change --select."},
               {"--select 'resi 900'", "Change --select."},
               {"--without-chain A", "atoms of other chains. Change --chain or --without-chain."},
               {"--no-polymers", "dropped 327 polymer atoms. Leave out --no-polymers."}};
  for (const auto& c : cases) {
    for (const std::string command : {"info", "compute", "verify", "bench"}) {
      const std::string alpha = command == "info" ? "" : " --alpha 1";
      const Outcome outcome = run(command + " '" + file + "' " + c.options + alpha);
      EXPECT_EQ(outcome.code, 2) << command << ' ' << c.options;
      EXPECT_TRUE(contains(outcome.err, c.said)) << command << ' ' << outcome.err;
    }
  }
  // One of two models may lack it.
  const std::string atom =
      "HETATM    1  O   HOH %   1      27.340  24.430   2.614  1.00  9.67           O  \n";
  std::string a = atom, b = atom;
  a.replace(a.find('%'), 1, "A");
  b.replace(b.find('%'), 1, "B");
  const fs::path two = write("two.pdb", "MODEL        1\n" + a + "ENDMDL\nMODEL        2\n" + b);
  const std::string all = "info '" + two.string() + "' --waters --model all --select 'chain ";
  EXPECT_EQ(run(all + "B'").code, 0);
  EXPECT_EQ(run(all + "C'").code, 2);
  EXPECT_TRUE(contains(run("info '" + two.string() + "'").err, "dropped 1 water. Add --waters."));
}

// Expects that the text does not move the cursor, ring the bell, or reverse the direction of
// writing.
void expect_shown_safely(const std::string& text, const std::string& what) {
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    EXPECT_TRUE((byte >= 0x20 && byte != 0x7f) || c == '\n') << what << ": byte " << int{byte};
  }
  for (const char* hidden : {"\u009b", "\u202e", "\xff", "\u2028"}) {
    EXPECT_FALSE(text.find(hidden) != std::string::npos) << what << ": " << text;
  }
}

TEST_F(Cli, WhatFilesAndTheirNamesHoldCannotCommandATerminal) {
  const std::string evil = "\x1b[31m\x1b]0;x\a\u009b\u202e\u2028";
  const fs::path file = write(
      "a\x1b\a\n\u009b\u202e.pdb",
      "TITLE     " + evil + "\xff\rb\n" +
          "HETATM    1  C\x1b\x9b\x07L\xffG \x1b   1      27.340  24.430   2.614  1.00  9.67\n"
          "HETATM    2 ZN\x1b  L\xffG B   1      29.340  24.430   2.614  1.00  9.67\n");
  const std::string quoted = "'" + file.string() + "' ";
  const std::string out = "'" + (folder_ / "out").string() + "'";
  for (const std::string& arguments :
       {"info " + quoted, "info " + quoted + "--json -", "compute " + quoted + "--alpha 1",
        "compute " + quoted + "--alpha 1 --json -", "compute " + quoted + "--alpha 1 --csv -",
        "compute " + quoted + "--alpha 1 --out " + out, "bench " + quoted + "--alpha 1 --runs 1",
        "verify " + quoted + "--alpha 1", "info " + quoted + "--chain '" + evil + "'",
        "info " + quoted + "--select 'name " + evil + "('", "info " + quoted + "--model '\x1b'",
        "info " + quoted + "--radii '" + evil + "'", "info " + quoted + "--assembly '" + evil + "'",
        "info '" + file.string() + "\x1b'", "compute " + quoted + "--alpha '" + evil + "'",
        "compute " + quoted + "--alpha 1 --json '" + evil + "/x'"}) {
    const Outcome outcome = run(arguments);
    expect_shown_safely(outcome.out, arguments);
    expect_shown_safely(outcome.err, arguments);
  }
  expect_shown_safely(contents(folder_ / "out"), "--out");
  const json report = json::parse(run("info " + quoted + "--json -").out);
  EXPECT_EQ(report["input"]["file"], file.string()) << "JSON says the same in escapes";
  EXPECT_TRUE(contains(run("info " + quoted).out, "title       \\x1B[31m"));
}

TEST_F(Cli, BadInputIsCode3AndNamesFileAndLine) {
  const fs::path bad = write("bad.xyzr", "0 0 0 1.5\n0 0 banana 1.5\n");
  const Outcome outcome = run("compute '" + bad.string() + "' --alpha 1");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_TRUE(contains(outcome.err, "bad.xyzr, line 2")) << outcome.err;
  const fs::path pixels = write("noise.pdb", std::string("\x89PNG\r\n\x1a\n\0\0", 10));
  for (const std::string& file : {std::string("/nonexistent/x.pdb"), folder_.string(),
                                  write("empty.pdb", "").string(), pixels.string()}) {
    for (const char* command : {"info", "compute --alpha 1", "verify --alpha 1"}) {
      const Outcome failed = run(std::string(command) + " '" + file + "'");
      EXPECT_EQ(failed.code, 3) << command << " " << file << "\n" << failed.err;
      EXPECT_TRUE(contains(failed.err, file)) << failed.err;
    }
  }
}

TEST_F(Cli, AnEngineThatCannotBeHadIsNotReplacedInSilence) {
  const Outcome gpu = run("compute '" + cube_.string() + "' --alpha 1 --engine gpu");
  if (gpu.code == 0) GTEST_SKIP() << "there is a GPU";
  EXPECT_EQ(gpu.code, 4);
  EXPECT_TRUE(contains(gpu.err, "The GPU engine cannot be used.")) << gpu.err;
  EXPECT_TRUE(contains(gpu.err, "\"cpu\" or \"auto\"")) << gpu.err;
  EXPECT_FALSE(contains(gpu.err, "runs instead")) << "nothing runs: " << gpu.err;
}

TEST_F(Cli, UnwritableOutputIsCode5) {
  const std::string base = "compute '" + cube_.string() + "' --alpha 1 ";
  EXPECT_EQ(run(base + "--out /nonexistent/x").code, 5);
  EXPECT_EQ(run(base + "--json /nonexistent/x").code, 5);
  EXPECT_EQ(run(base + "--out '" + folder_.string() + "'").code, 5);
}

TEST_F(Cli, JsonCarriesCountsHashTimesAndProvenance) {
  const json result = compute_json("'" + cube_.string() + "' --alpha 1 --engine cpu");
  // At alpha 1 the corners' spheres (1.5² + 1 >= 3) reach the middle, so the cube is filled.
  EXPECT_EQ(result["counts"]["vertices"], 8);
  const int edges = result["counts"]["edges"], triangles = result["counts"]["triangles"],
            tetrahedra = result["counts"]["tetrahedra"];
  EXPECT_TRUE(tetrahedra == 5 || tetrahedra == 6) << tetrahedra;
  EXPECT_EQ(8 - edges + triangles - tetrahedra, 1);
  EXPECT_EQ(result["euler_characteristic"], 1);
  EXPECT_EQ(result["hash"].get<std::string>().size(), 16u);
  EXPECT_FALSE(result["timings_ms"]["stages"].empty());
  EXPECT_EQ(result["input"]["balls"], 8);
  EXPECT_EQ(result["input"]["sha256"].get<std::string>().size(), 64u);
  EXPECT_EQ(result["request"]["alpha_angstrom2"], 1.0);
  EXPECT_TRUE(result["program"].contains("commit"));
}

TEST_F(Cli, Sha256IsTheFiles) {
  const fs::path two = write("two.xyzr", "0 0 0 1\n1 0 0 1\n");
  std::FILE* pipe = ::popen(("sha256sum '" + two.string() + "'").c_str(), "r");
  ASSERT_TRUE(pipe);
  char digest[65] = {};
  ASSERT_EQ(std::fread(digest, 1, 64, pipe), 64u);
  ::pclose(pipe);
  EXPECT_EQ(compute_json("'" + two.string() + "' --alpha 0")["input"]["sha256"], digest);
}

TEST_F(Cli, TheHashIsTheSameOnEveryEngineAndThreadCount) {
  const std::string file = "'" ALPHASCOPE_SOURCE_DIR "/resources/molecules/1crn.pdb'";
  const std::string request = file + " --alpha 1.4 --solvent 0.5";
  const json one = compute_json(request + " --engine cpu --threads 1");
  EXPECT_EQ(compute_json(request + " --engine cpu --threads 2")["hash"], one["hash"]);
  EXPECT_EQ(compute_json(request + " --engine cgal --threads 1")["hash"], one["hash"]);
  EXPECT_EQ(compute_json(request + " --engine auto")["hash"], one["hash"]);
  EXPECT_NE(compute_json(file + " --alpha 1.3 --solvent 0.5")["hash"], one["hash"]);
  const json tetrahedra = compute_json(request + " --tetrahedra-only");
  EXPECT_EQ(tetrahedra["tetrahedra_hash"], one["tetrahedra_hash"]);
  EXPECT_EQ(tetrahedra["counts"]["tetrahedra"], one["counts"]["tetrahedra"]);
  EXPECT_TRUE(tetrahedra["counts"]["edges"].is_null()) << "unknown is not zero";
}

TEST_F(Cli, TheThreadsThatAreSaidAreThoseThatAreUsed) {
  const std::string file = "'" ALPHASCOPE_SOURCE_DIR "/resources/molecules/1crn.pdb' --alpha 1 ";
  for (const char* engine : {"cpu", "cgal", "tuples-cpu"}) {
    const std::string chosen = file + "--engine " + engine + " --threads ";
    EXPECT_EQ(compute_json(chosen + "1")["engine"]["device"], "CPU, 1 thread");
    // A number of threads above the machine's means all of them.
    const json all = compute_json(chosen + "0"), more = compute_json(chosen + "1024");
    EXPECT_EQ(more["engine"]["device"], all["engine"]["device"]);
    EXPECT_EQ(more["request"]["threads"], 1024);
    EXPECT_EQ(more["hash"], all["hash"]);
  }
}

TEST_F(Cli, TheTupleEngineHasSwitchesAndCountsItsTuples) {
  const std::string file = "'" ALPHASCOPE_SOURCE_DIR "/resources/molecules/1crn.pdb' --alpha 1.4";
  const json expected = compute_json(file + " --engine cpu");
  const json plain = compute_json(file + " --engine tuples-cpu");
  const json bare =
      compute_json(file +
                   " --engine tuples-cpu --no-edge-optimisation --no-alpha-optimisation "
                   "--tuple-grid 100 --tuples-per-batch 5000");
  EXPECT_EQ(plain["hash"], expected["hash"]);
  EXPECT_EQ(bare["hash"], expected["hash"]);
  EXPECT_FALSE(expected["engine"].contains("counters"));
  const json &few = plain["engine"]["counters"], &many = bare["engine"]["counters"];
  EXPECT_LT(few["4-tuples into kernel II"].get<long>(), few["4-tuples enumerated"].get<long>());
  EXPECT_EQ(many["4-tuples into kernel II"], many["4-tuples enumerated"]);
  EXPECT_LT(10 * few["4-tuples enumerated"].get<long>(), many["4-tuples enumerated"].get<long>());
  EXPECT_EQ(many["valid 4-tuples"], expected["counts"]["tetrahedra"]);
  EXPECT_EQ(bare["request"]["tuples"]["grid"], "100");
  EXPECT_FALSE(bare["request"]["tuples"]["edge_optimisation"]);
}

// Without a device, the message says so and names the engine to choose. The CPU does not compute
// instead.
TEST_F(Cli, TheTupleEngineOnTheGpuWorksOrSaysWhyNot) {
  const std::string request = "compute '" + cube_.string() + "' --alpha 1 --engine tuples-gpu";
  const Outcome outcome = run(request + " --pageable --streams 1 --no-texture");
  if (outcome.code == 0) {
    EXPECT_TRUE(contains(outcome.out, "without pinned memory and streams and textures"));
  } else {
    EXPECT_EQ(outcome.code, 4);
    EXPECT_TRUE(contains(outcome.err, "tuples-cpu")) << outcome.err;
  }
}

TEST_F(Cli, TheComplexFileHoldsWhatItSays) {
  const fs::path out = folder_ / "cube.alpha";
  const Outcome outcome =
      run("compute '" + cube_.string() + "' --alpha 1 --out '" + out.string() + "'");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  std::ifstream file(out);
  std::string line, last;
  std::map<std::string, long> announced, found;
  std::string section;
  ASSERT_TRUE(std::getline(file, line));
  EXPECT_EQ(line, "alphascope-complex 1");
  while (std::getline(file, line)) {
    std::istringstream words(line);
    std::string first;
    words >> first;
    if (first == "balls" || first == "vertices" || first == "edges" || first == "triangles" ||
        first == "tetrahedra") {
      section = first;
      words >> announced[section];
    } else if (line != "end" && !section.empty()) {
      ++found[section];
      std::istringstream fields(line);
      int count = 0;
      for (std::string field; fields >> field;) ++count;
      const std::map<std::string, int> expected{
          {"balls", 4}, {"vertices", 3}, {"edges", 4}, {"triangles", 5}, {"tetrahedra", 6}};
      EXPECT_EQ(count, expected.at(section)) << line;
    }
    last = line;
  }
  EXPECT_EQ(last, "end");
  EXPECT_EQ(announced, found);
  EXPECT_EQ(announced["balls"], 8);
  EXPECT_TRUE(contains(contents(out), "\nballs 8\n0.000 0.000 0.000 1.500\n"));
}

TEST_F(Cli, OutputsReplaceWholeFilesAndLeaveNothingBehind) {
  const fs::path out = write("old.alpha", "the old one");
  fs::create_symlink(out, folder_ / "link");
  const std::string link = "'" + (folder_ / "link").string() + "'";
  EXPECT_EQ(run("compute '" + cube_.string() + "' --alpha 1 --out " + link).code, 0);
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_TRUE(contains(contents(out), "alphascope-complex 1"));
  EXPECT_EQ(run("compute '" + cube_.string() + "' --alpha 1 --out /dev/null").code, 0);
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  const std::string before = contents(out);
  EXPECT_EQ(run("compute /nonexistent --alpha 1 --out " + link).code, 3);
  EXPECT_EQ(contents(out), before);
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_)) {
    EXPECT_FALSE(entry.path().extension() == ".tmp") << entry.path();
  }
}

// Two balls of 1 Å, 3.000001 Å apart. rho of their edge is 1.25000150000025 Å².
TEST_F(Cli, AlphaIsTheDecimalThatIsTyped) {
  const std::string file = "'" + write("two.xyzr", "0 0 0 1\n3.000001 0 0 1\n").string() + "'";
  const auto edges = [&](const std::string& more) {
    const Outcome outcome = run("compute " + file + " --json - " + more);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return json::parse(outcome.out)["counts"]["edges"].get<int>();
  };
  for (const char* engine : {"cpu", "cgal", "tuples-cpu"}) {
    const std::string by = std::string(" --engine ") + engine;
    EXPECT_EQ(edges("--alpha 1.25000150000025" + by), 1);
    EXPECT_EQ(edges("--alpha 1.250001500000249999" + by), 0);  // rounds to the other double
  }
  const json request =
      json::parse(run("compute " + file + " --alpha 1.250001500000249999 --json -").out)["request"];
  EXPECT_EQ(request["alpha_angstrom2"], "1.250001500000249999");
  EXPECT_EQ(request["alpha_used_square_lattice_units"], "1250001500000.249999");
  EXPECT_EQ(
      run("verify " + file + " --alpha 1.25000150000025,1.250001500000249999 --definition").code,
      0);
  const Outcome refused = run("compute " + file + " --alpha 1.2500015000002499999");
  EXPECT_EQ(refused.code, 2);
  EXPECT_TRUE(contains(refused.err, "more than 18 digits behind the point")) << refused.err;
}

TEST_F(Cli, VerifySaysIdentical) {
  const Outcome outcome =
      run("verify '" + cube_.string() + "' --alpha -1,0,0.75,1,100 --definition");
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "identical to CGAL"));
  EXPECT_TRUE(contains(outcome.out, "vertices: 8 of 8"));
  EXPECT_TRUE(contains(outcome.out, ", 0 false"));
  const Outcome as_json = run("verify '" + cube_.string() + "' --alpha 1 --json -");
  EXPECT_EQ(as_json.code, 0);
  EXPECT_EQ(json::parse(as_json.out)["identical"], true);
}

TEST_F(Cli, VerifyProvesTheDefinitionOfTetrahedraAlone) {
  const Outcome outcome =
      run("verify '" + cube_.string() + "' --alpha 0.75,1 --definition --tetrahedra-only");
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "definition: "));
  EXPECT_TRUE(contains(outcome.out, ", 0 false"));
}

// At this alpha the engine triangulates all balls, since its own route has a limit.
TEST_F(Cli, VerifyComparesWholeTriangulations) {
  const Outcome outcome = run("verify '" + cube_.string() + "' --alpha 1e12");
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "identical to CGAL")) << outcome.out;
}

// For balls in a plane the engine uses CGAL's triangulation itself.
TEST_F(Cli, VerifyDoesNotCompareCgalWithItself) {
  const fs::path plane = write("plane.xyzr", "0 0 0 1\n3 0 0 1\n0 3 0 1\n4 4 0 1\n");
  const std::string large = "verify '" + plane.string() + "' --alpha 1e12";
  for (const std::string& only : {std::string(), std::string(" --tetrahedra-only")}) {
    const Outcome outcome = run(large + only);
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    EXPECT_FALSE(contains(outcome.out, "identical to CGAL")) << outcome.out;
    EXPECT_TRUE(contains(outcome.out,
                         "both rest on CGAL's triangulation; checked against the definition "
                         "instead"))
        << outcome.out;
    EXPECT_TRUE(contains(outcome.out, "definition: ")) << outcome.out;
    EXPECT_TRUE(contains(outcome.out, ", 0 false")) << outcome.out;
  }
  const json results = json::parse(run(large + ",0 --json -").out)["results"];
  EXPECT_EQ(results[0]["comparison"]["both_rest_on_cgal"], true);
  EXPECT_EQ(results[0]["definition"]["failures"], 0);
  EXPECT_EQ(results[0]["ours"]["engine"]["route"],
            "regular triangulation, filtration, then threshold");
}

TEST_F(Cli, BenchWritesTableAndCsv) {
  const fs::path csv = folder_ / "times.csv";
  const Outcome outcome = run("bench '" + cube_.string() + "' --alpha 0,1 --threads 1,2 --runs 2 " +
                              "--tetrahedra-only --csv '" + csv.string() + "'");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "cube.xyzr"));
  const auto rows = csv_rows(contents(csv));
  ASSERT_EQ(rows.size(), 4u);
  for (const auto& row : rows) EXPECT_EQ(row.at("identical"), "1") << "to CGAL";
}

// Four balls of radius 1 at the corners of a tetrahedron with edges of 2.5. With a solvent of 1 the
// radius² of its orthosphere is negative.
TEST_F(Cli, BenchGrowsTheBallsByTheSolvent) {
  const fs::path file =
      write("four.xyzr", "0 0 0 1\n2.5 0 0 1\n1.25 2.165 0 1\n1.25 0.722 2.041 1\n");
  const auto tetrahedra = [&](const std::string& solvent) {
    const Outcome outcome =
        run("bench '" + file.string() + "' --alpha 0 --runs 1 --solvent " + solvent + " --csv -");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return csv_rows(outcome.out).at(0).at("tetrahedra");
  };
  EXPECT_EQ(tetrahedra("0"), "0");
  EXPECT_EQ(tetrahedra("1"), "1");
}

TEST_F(Cli, InfoTellsWhatIsUsed) {
  const Outcome outcome = run("info '" ALPHASCOPE_SOURCE_DIR "/resources/molecules/1crn.pdb'");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_TRUE(contains(outcome.out, "used 327 of 327 atoms")) << outcome.out;
  EXPECT_TRUE(contains(outcome.out, "nothing was rounded"));
}

TEST_F(Cli, SelectionAndAssemblyComeFromTheCommandLine) {
  const std::string file = "'" ALPHASCOPE_SOURCE_DIR "/resources/molecules/1crn.pdb' --alpha 0 ";
  const json picked = compute_json(file + "--select 'name CA'");
  EXPECT_EQ(picked["input"]["balls"], 46) << "crambin has 46 residues";
  EXPECT_EQ(picked["input"]["selection_expression"], "name CA");
  EXPECT_EQ(compute_json(file + "--assembly 1")["input"]["assembly"], "1");
  EXPECT_EQ(run("compute " + file + "--select 'chain and'").code, 2);
  EXPECT_EQ(run("compute " + file + "--assembly nosuch").code, 2);
  // The sizes are those of the deposited structure, expanded.
  const std::string info = "info '" ALPHASCOPE_SOURCE_DIR "/resources/molecules/1crn.pdb'";
  EXPECT_TRUE(contains(run(info).out, "--assembly 1: 1 operator, 327 atoms"));
  EXPECT_TRUE(contains(run(info + " --assembly 1").out, "1 operator, expanded here"));
}

// Counts that the thesis gives for its reference molecule.
TEST_F(Cli, GramicidinHasItsKnownCounts) {
  ALPHASCOPE_NEED_TEST_DATA();
  const fs::path file = test_data_folder() / "ladder" / "1grm.crd";
  const struct {
    const char* request;
    int edges, triangles, tetrahedra;
  } known[] = {{"--alpha 0", 576, 336, 20},
               {"--alpha 1", 812, 650, 136},
               {"--alpha 1.4", 906, 783, 185},
               {"--alpha 0 --solvent 1.4", 1393, 1977, 846}};
  for (const auto& k : known) {
    const json counts = compute_json("'" + file.string() + "' " + k.request)["counts"];
    EXPECT_EQ(counts["edges"], k.edges) << k.request;
    EXPECT_EQ(counts["triangles"], k.triangles) << k.request;
    EXPECT_EQ(counts["tetrahedra"], k.tetrahedra) << k.request;
  }
}

}  // namespace
}  // namespace alphascope::testing
