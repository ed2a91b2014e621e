// The real alphascope-cli on small files: results, exit codes, and messages for bad input.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>
#include <utility>
#include <vector>

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

struct Outcome {
  int code = -1;
  std::string out, err;
};

std::string contents(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

// What pandas or R would read: names and rows of fields.
std::vector<std::map<std::string, std::string>> csv_rows(const std::string& text) {
  std::vector<std::vector<std::string>> lines(1);
  std::string field;
  bool quoted = false;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    if (c == '"') {
      if (quoted && k + 1 < text.size() && text[k + 1] == '"') field += text[++k];
      else quoted = !quoted;
    } else if (!quoted && (c == ',' || c == '\n')) {
      lines.back().push_back(std::exchange(field, {}));
      if (c == '\n') lines.emplace_back();
    } else {
      field += c;
    }
  }
  lines.pop_back();
  std::vector<std::map<std::string, std::string>> rows;
  for (std::size_t n = 1; n < lines.size(); ++n) {
    EXPECT_EQ(lines[n].size(), lines[0].size()) << "row " << n;
    rows.emplace_back();
    for (std::size_t k = 0; k < lines[0].size(); ++k) rows.back()[lines[0][k]] = lines[n].at(k);
  }
  return rows;
}

class Cli : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::path(::testing::TempDir()) / "alphascope_cli_XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
    // A cube of eight equal balls: every tie that there can be, and counts known by hand.
    std::string cube;
    for (int i = 0; i < 8; ++i) {
      cube += std::to_string(2 * (i & 1)) + " " + std::to_string(i & 2) + " " +
              std::to_string((i & 4) / 2) + " 1.5\n";
    }
    cube_ = write("cube.xyzr", cube);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }

  Outcome run(const std::string& arguments) const {
    const fs::path out = folder_ / "stdout", err = folder_ / "stderr";
    const std::string command = std::string("'" ALPHASCOPE_CLI "' ") + arguments + " >'" +
                                out.string() + "' 2>'" + err.string() + "' </dev/null";
    const int status = std::system(command.c_str());
    Outcome outcome;
    outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
    outcome.out = contents(out);
    outcome.err = contents(err);
    return outcome;
  }

  json compute_json(const std::string& arguments) const {
    const Outcome outcome = run("compute " + arguments + " --json -");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return json::parse(outcome.out);
  }

  static bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  }

  fs::path folder_, cube_;
};

TEST_F(Cli, HelpHasExamplesAndExitCodes) {
  const Outcome outcome = run("--help");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_TRUE(contains(outcome.out, "Examples:"));
  EXPECT_TRUE(contains(outcome.out, "Exit codes:"));
  for (const char* command : {"info", "compute", "verify", "bench", "screenshot"}) {
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
  // At alpha 1 the corners' spheres (1.5² + 1 >= 3) reach the middle: the cube is filled.
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

TEST_F(Cli, TheTupleEngineHasSwitchesAndCountsItsTuples) {
  const std::string file = "'" ALPHASCOPE_SOURCE_DIR "/resources/molecules/1crn.pdb' --alpha 1.4";
  const json expected = compute_json(file + " --engine cpu");
  const json plain = compute_json(file + " --engine tuples-cpu");
  const json bare = compute_json(
      file + " --engine tuples-cpu --no-edge-optimisation --no-alpha-optimisation "
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

// Where there is no device, it says so and what to choose; the CPU does not stand in for it.
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
  const Outcome outcome = run("compute '" + cube_.string() + "' --alpha 1 --out '" + out.string() + "'");
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
    EXPECT_FALSE(contains(entry.path().filename().string(), "alpha.")) << entry.path();
  }
}

TEST_F(Cli, VerifySaysIdentical) {
  const Outcome outcome = run("verify '" + cube_.string() + "' --alpha -1,0,0.75,1,100 --definition");
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "identical to CGAL"));
  EXPECT_TRUE(contains(outcome.out, "vertices: 8 of 8"));
  EXPECT_TRUE(contains(outcome.out, ", 0 false"));
  const Outcome as_json = run("verify '" + cube_.string() + "' --alpha 1 --json -");
  EXPECT_EQ(as_json.code, 0);
  EXPECT_EQ(json::parse(as_json.out)["identical"], true);
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
}

constexpr const char* kProvenance[] = {
    "file", "sha256", "format", "model", "assembly", "options", "selection_expression", "selection",
    "radii", "lattice_unit_angstrom", "rounding_angstrom", "radius_rounding_angstrom", "program"};

// Two models: an edge, and three balls of which the third is a water's.
constexpr const char* kTwoModels =
    "MODEL        4\n"
    "ATOM      1  CA  ALA A   1       0.000   0.000   0.000  1.00  9.67           C  \n"
    "ATOM      2  CA  ALA A   2       3.000   0.000   0.000  1.00  9.67           C  \n"
    "ENDMDL\nMODEL        9\n"
    "ATOM      1  CA  ALA A   1       0.000   0.000   0.000  1.00  9.67           C  \n"
    "ATOM      2  CA  ALA A   2       9.000   0.000   0.000  1.00  9.67           C  \n"
    "HETATM    3  O   HOH A   3       1.500   1.500   0.000  1.00  9.67           O  \n"
    "ENDMDL\n";

TEST_F(Cli, EachModelGivesAResultOfItsOwn) {
  const std::string file = "'" + write("two.pdb", kTwoModels).string() + "' --alpha 0 ";
  const fs::path csv = folder_ / "m.csv", out = folder_ / "m.alpha", js = folder_ / "m.json";
  const Outcome outcome = run("compute " + file + "--model all --csv '" + csv.string() + "' --out '" +
                              out.string() + "' --json '" + js.string() + "'");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json models = json::parse(contents(js))["models"];
  ASSERT_EQ(models.size(), 2u);
  const auto rows = csv_rows(contents(csv));
  ASSERT_EQ(rows.size(), 2u);
  for (int k = 0; k < 2; ++k) {
    // The very result that the model gives alone.
    const json alone = compute_json(file + "--model " + std::to_string(k + 1));
    EXPECT_EQ(models[k]["hash"], alone["hash"]);
    EXPECT_EQ(models[k]["counts"], alone["counts"]);
    EXPECT_EQ(models[k]["input"]["selection"], alone["input"]["selection"]);
    EXPECT_EQ(models[k]["input"]["model"], k + 1);
    EXPECT_EQ(rows[k].at("model"), std::to_string(k + 1));
    EXPECT_EQ(rows[k].at("hash"), alone["hash"]);
    EXPECT_EQ(rows[k].at("edges"), alone["counts"]["edges"].dump());
    EXPECT_TRUE(contains(outcome.out, alone["hash"])) << outcome.out;
  }
  EXPECT_EQ(models[0]["counts"]["edges"], 1);
  EXPECT_EQ(models[1]["counts"]["edges"], 0);
  EXPECT_EQ(models[0]["input"]["model_number_in_file"], 4);
  // One document after another.
  const std::string text = contents(out);
  std::size_t documents = 0;
  for (std::size_t at = text.find("alphascope-complex 1\n"); at != text.npos;
       at = text.find("alphascope-complex 1\n", at + 1)) {
    ++documents;
  }
  EXPECT_EQ(documents, 2u);
  EXPECT_TRUE(contains(text, "\nmodel 2\n"));
  EXPECT_TRUE(text.ends_with("\nend\n"));
}

TEST_F(Cli, JoinedModelsAreOneSet) {
  const std::string file = "'" + write("two.pdb", kTwoModels).string() + "' ";
  const json joined = compute_json(file + "--alpha 0 --model joined --waters");
  EXPECT_EQ(joined["input"]["balls"], 5);
  EXPECT_EQ(joined["input"]["model"], "joined");
  EXPECT_EQ(joined["input"]["options"], "--waters");
  EXPECT_EQ(compute_json(file + "--alpha 0 --model 2 --no-polymers --waters")["input"]["balls"], 1);
  EXPECT_EQ(run("compute " + file + "--alpha 0 --model 3").code, 2);
  EXPECT_EQ(run("screenshot " + file + "--alpha 0 --model all -o '" +
                (folder_ / "x.png").string() + "'").code, 2) << "one picture, one model";
}

TEST_F(Cli, VerifyAndInfoTakeEachModelToo) {
  const std::string file = "'" + write("two.pdb", kTwoModels).string() + "' --model all ";
  const Outcome verified = run("verify " + file + "--alpha 0,9 --json -");
  ASSERT_EQ(verified.code, 0) << verified.err;
  const json results = json::parse(verified.out)["results"];
  ASSERT_EQ(results.size(), 4u);
  EXPECT_EQ(results[3]["input"]["model"], 2);
  const json info = json::parse(run("info " + file + "--json -").out);
  ASSERT_EQ(info["models"].size(), 2u);
  EXPECT_EQ(info["models"][1]["input"]["atoms_used"], 2);
  EXPECT_TRUE(contains(run("info " + file).out, "model 2: used 2 of 3 atoms; dropped 1 water"));
}

TEST_F(Cli, EveryOutputSaysWhereItComesFrom) {
  const fs::path csv = folder_ / "c.csv", times = folder_ / "t.csv", out = folder_ / "c.alpha";
  const fs::path table = write("mine.txt", "C 1.5\nX 1.25\n");
  const std::string file = "'" + cube_.string() + "' --alpha 1 --radii '" + table.string() + "' ";
  ASSERT_EQ(run("compute " + file + "--csv '" + csv.string() + "' --out '" + out.string() + "'").code, 0);
  ASSERT_EQ(run("bench " + file + "--runs 1 --csv '" + times.string() + "'").code, 0);
  const json result = compute_json(file);
  const std::string text = contents(out);
  for (const fs::path& path : {csv, times}) {
    const auto rows = csv_rows(contents(path));
    ASSERT_EQ(rows.size(), 1u);
    for (const char* key : kProvenance) EXPECT_TRUE(rows[0].contains(key)) << path << ' ' << key;
    EXPECT_EQ(rows[0].at("sha256"), result["input"]["sha256"]);
    EXPECT_EQ(rows[0].at("lattice_unit_angstrom"), "0.001");
    EXPECT_TRUE(contains(rows[0].at("radii"), result["input"]["radii"]["table_sha256"]));
    EXPECT_EQ(rows[0].at("selection"), result["input"]["selection"]);
  }
  for (const char* key : kProvenance) {
    EXPECT_TRUE(contains(text, std::string("\n") + key + " ")) << key;
  }
  EXPECT_TRUE(contains(run("compute " + file).out, result["input"]["sha256"]));
}

TEST_F(Cli, PicturesSayWhereTheyComeFrom) {
  const fs::path picture = folder_ / "cube.png";
  const Outcome outcome = run("screenshot '" + cube_.string() + "' --alpha 1 --size 64x64 -o '" +
                              picture.string() + "'");
  if (outcome.code != 0) GTEST_SKIP() << "no renderer here: " << outcome.err;
  const std::string png = contents(picture);
  const json input = compute_json("'" + cube_.string() + "' --alpha 1")["input"];
  EXPECT_TRUE(png.starts_with("\x89PNG"));
  EXPECT_TRUE(contains(png, "alphascope:sha256"));
  EXPECT_TRUE(contains(png, input["sha256"]));
  EXPECT_TRUE(contains(png, "alphascope:alpha_angstrom2"));
}

TEST_F(Cli, InterruptIsCode130AndWritesNothing) {
  // Enough work to be still running when the signal comes: many runs of a benchmark.
  const fs::path csv = folder_ / "times.csv";
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    std::freopen("/dev/null", "w", stdout);
    std::freopen("/dev/null", "w", stderr);
    ::execl(ALPHASCOPE_CLI, ALPHASCOPE_CLI, "bench",
            ALPHASCOPE_SOURCE_DIR "/resources/molecules/4hhb.pdb.gz", "--alpha", "10", "--runs",
            "1000", "--csv", csv.c_str(), static_cast<char*>(nullptr));
    ::_exit(99);
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(700));
  ASSERT_EQ(::kill(child, SIGINT), 0);
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_FALSE(fs::exists(csv));
}

// The counts that the reference molecule of the thesis must give.
TEST_F(Cli, GramicidinHasItsKnownCounts) {
  const fs::path file = fs::path(ALPHASCOPE_TEST_DATA) / "ladder" / "1grm.crd";
  if (std::string(ALPHASCOPE_TEST_DATA).empty() || !fs::exists(file)) {
    GTEST_SKIP() << "needs ladder/1grm.crd in ALPHASCOPE_TEST_DATA";
  }
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
