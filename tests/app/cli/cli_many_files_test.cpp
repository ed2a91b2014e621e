// SPDX-License-Identifier: GPL-3.0-or-later
// Tests alphascope-cli on many files, on lists of them, and on standard input.
#include <sys/resource.h>

#include <set>

#include "tests/app/cli/cli_fixture.hpp"
#include "tests/support/sanitizer.hpp"

namespace alphascope::testing {
namespace {

const std::string kCrambin = ALPHASCOPE_SOURCE_DIR "/resources/molecules/1crn.pdb";

class CliManyFiles : public Cli {
 protected:
  // The lines of a table, from the line that begins with `heading`.
  static std::vector<std::string> table(const std::string& text, const std::string& heading) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
      if (!lines.empty() || line.starts_with(heading)) lines.push_back(line);
    }
    return lines;
  }
};

TEST_F(CliManyFiles, OneTableForAllAndAnErrorDoesNotEndIt) {
  const fs::path bad = write("bad.xyzr", "0 0 0 1.5\n0 0 banana 1.5\n");
  const fs::path csv = folder_ / "t.csv", js = folder_ / "t.json";
  const std::string files =
      "'" + cube_.string() + "' '" + bad.string() + "' /nonexistent/x.pdb '" + kCrambin + "'";
  const Outcome outcome = run("compute " + files + " --alpha 1.4 --csv '" + csv.string() +
                              "' --json '" + js.string() + "'");
  EXPECT_EQ(outcome.code, 3) << "that of the first that failed";
  EXPECT_TRUE(contains(outcome.err, "alphascope-cli: " + bad.string() + ", line 2: "));
  EXPECT_TRUE(contains(outcome.err, "alphascope-cli: /nonexistent/x.pdb: there is no such file"));
  EXPECT_TRUE(contains(outcome.err, "alphascope-cli: 2 of 4 files failed.")) << outcome.err;

  const std::vector<std::string> lines = table(outcome.out, "file ");
  ASSERT_EQ(lines.size(), 3u) << outcome.out;
  const std::size_t hash_column = lines[0].find("hash");
  const json alone[] = {compute_json("'" + cube_.string() + "' --alpha 1.4"),
                        compute_json("'" + kCrambin + "' --alpha 1.4")};
  const json together = json::parse(contents(js));
  const auto rows = csv_rows(contents(csv));
  ASSERT_EQ(together["results"].size(), 2u);
  ASSERT_EQ(rows.size(), 2u);
  for (int k = 0; k < 2; ++k) {
    const std::string hash = alone[k]["hash"], file = k == 0 ? cube_.string() : kCrambin;
    EXPECT_EQ(together["results"][k]["hash"], hash);
    EXPECT_EQ(together["results"][k]["counts"], alone[k]["counts"]);
    EXPECT_EQ(together["results"][k]["input"]["file"], file);
    EXPECT_EQ(rows[k].at("hash"), hash);
    EXPECT_EQ(rows[k].at("file"), file);
    EXPECT_TRUE(lines[1 + k].starts_with(file));
    EXPECT_EQ(lines[1 + k].find(hash), hash_column) << "aligned";
  }
  ASSERT_EQ(together["failed"].size(), 2u);
  EXPECT_EQ(together["failed"][1]["file"], "/nonexistent/x.pdb");
  EXPECT_TRUE(contains(together["failed"][0]["error"], "line 2"));
  EXPECT_TRUE(together["program"].contains("commit"));
}

TEST_F(CliManyFiles, InfoGivesOneTableToo) {
  const fs::path csv = folder_ / "t.csv";
  const std::string files = "'" + cube_.string() + "' /nonexistent '" + kCrambin + "'";
  const Outcome outcome = run("info " + files + " --csv '" + csv.string() + "'");
  EXPECT_EQ(outcome.code, 3);
  const std::vector<std::string> lines = table(outcome.out, "file ");
  ASSERT_EQ(lines.size(), 3u) << outcome.out;
  EXPECT_EQ(lines[1].find("XYZR"), lines[0].find("format"));
  EXPECT_EQ(lines[2].find("PDB"), lines[0].find("format"));
  const auto rows = csv_rows(contents(csv));
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[1].at("balls"), "327");
  EXPECT_EQ(rows[1].at("file"), kCrambin);
  const json all = json::parse(run("info " + files + " --json -").out);
  EXPECT_EQ(all["results"][1]["input"]["balls"], 327);
  EXPECT_EQ(all["failed"][0]["file"], "/nonexistent");
  // A single file has a table as well.
  EXPECT_EQ(csv_rows(run("info '" + cube_.string() + "' --csv -").out).at(0).at("balls"), "8");
}

TEST_F(CliManyFiles, EachModelOfEachFileHasALine) {
  const fs::path two = write("two.xyz", "1\nfirst\nC 0 0 0\n2\nsecond\nC 0 0 0\nC 2 0 0\n");
  const Outcome outcome =
      run("compute '" + two.string() + "' '" + cube_.string() + "' --alpha 0 --model all");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(table(outcome.out, "file ").size(), 4u) << outcome.out;
}

TEST_F(CliManyFiles, NamesComeFromALine) {
  const fs::path odd = write("a\nb.xyzr", "0 0 0 1\n1 0 0 1\n");
  const fs::path lines = write("lines", cube_.string() + "\r\n\n" + kCrambin);
  const fs::path nulls = write("nulls", odd.string() + std::string(1, '\0') + kCrambin);
  const auto balls = [&](const std::string& arguments, const fs::path& input) {
    std::string all;
    const Outcome outcome = run("compute --alpha 0 --csv - " + arguments, input);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    for (const auto& row : csv_rows(outcome.out)) all += row.at("balls") + " ";
    return all;
  };
  EXPECT_EQ(balls("--files-from '" + lines.string() + "'", "/dev/null"), "8 327 ");
  EXPECT_EQ(balls("--files-from -", lines), "8 327 ");
  EXPECT_EQ(balls("--files-from - --null", nulls), "2 327 ");
  EXPECT_EQ(balls("'" + cube_.string() + "' --files-from -", lines), "8 8 327 ");
}

TEST_F(CliManyFiles, WhatConcernsNoFileEndsTheCommandAtOnce) {
  const std::string files = "'" + cube_.string() + "' '" + kCrambin + "' ";
  const fs::path empty = write("empty", "\n");
  const struct {
    std::string arguments;
    int code;
    const char* said;
  } cases[] = {
      {files + "--alpha 0 --radii nosuchset", 2, "There is no radii set"},
      {files + "--alpha 0 --model 0", 2, "--model takes"},
      {files + "--alpha 0 --out /nonexistent/x", 5, "/nonexistent/x"},
      {"--alpha 0", 2, "name a FILE, or a list of files with --files-from"},
      {"--alpha 0 --null '" + cube_.string() + "'", 2, "--null needs --files-from"},
      {"--alpha 0 --files-from /nonexistent", 3, "the list of files cannot be read"},
      {"--alpha 0 --files-from '" + folder_.string() + "'", 3, "the list of files cannot be read"},
      {"--alpha 0 --files-from '" + empty.string() + "'", 2, "the list names no files"},
      {"--alpha 0 --files-from '" + empty.string() + "' --out '" + empty.string() + "' - -", 2,
       "Standard input (-) can be read only once"}};
  for (const auto& c : cases) {
    const Outcome outcome = run("compute " + c.arguments);
    EXPECT_EQ(outcome.code, c.code) << c.arguments;
    EXPECT_TRUE(contains(outcome.err, c.said)) << outcome.err;
    EXPECT_FALSE(contains(outcome.err, "files failed")) << outcome.err;
  }
}

TEST_F(CliManyFiles, MemoryDoesNotGrowWithTheirNumber) {
  if (testing::kAddressSanitizer) {
    GTEST_SKIP() << "AddressSanitizer keeps what is freed for a while";
  }
  const auto most_memory = [&](int files) {
    std::string list;
    for (int n = 0; n < files; ++n) list += cube_.string() + "\n";
    const fs::path names = write("names", list), js = folder_ / "all.json";
    const pid_t child = ::fork();
    if (child == 0) {
      std::freopen("/dev/null", "w", stdout);
      std::freopen("/dev/null", "w", stderr);
      ::execl(ALPHASCOPE_CLI, ALPHASCOPE_CLI, "compute", "--alpha", "1", "--threads", "1",
              "--files-from", names.c_str(), "--json", js.c_str(), static_cast<char*>(nullptr));
      ::_exit(99);
    }
    int status = 0;
    struct rusage usage {};
    EXPECT_EQ(::wait4(child, &status, 0, &usage), child);
    EXPECT_EQ(status, 0);
    EXPECT_EQ(json::parse(contents(js))["results"].size(), static_cast<std::size_t>(files));
    return usage.ru_maxrss;  // KiB
  };
  const long few = most_memory(20), many = most_memory(2000);
  EXPECT_LT(many, few + 4096) << few << " KiB for 20 files";
}

TEST_F(CliManyFiles, StandardInputIsAFile) {
  const json file = compute_json("'" + kCrambin + "' --alpha 1.4");
  const fs::path packed = folder_ / "packed";
  ASSERT_EQ(std::system(("gzip -c '" + kCrambin + "' >'" + packed.string() + "'").c_str()), 0);
  for (const fs::path& input : {fs::path(kCrambin), packed}) {
    const Outcome outcome = run("compute - --alpha 1.4 --json -", input);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const json result = json::parse(outcome.out);
    EXPECT_EQ(result["hash"], file["hash"]);
    EXPECT_EQ(result["input"]["file"], "stdin");
    EXPECT_TRUE(run("info -", input).out.starts_with("stdin: used 327 of 327 atoms"));
  }
  EXPECT_EQ(run("verify - --alpha 1", kCrambin).code, 0);
  EXPECT_EQ(run("bench - --alpha 1 --runs 1", kCrambin).code, 0);
  const Outcome broken = run("compute - --alpha 1", write("broken", "0 0 0 1\n0 0 banana 1\n"));
  EXPECT_EQ(broken.code, 3);
  EXPECT_TRUE(contains(broken.err, "stdin, line 2")) << broken.err;
  EXPECT_TRUE(contains(run("compute - --alpha 1").err, "stdin: the file is empty"));
}

// A pipe delivers its data in pieces.
TEST_F(CliManyFiles, StandardInputMayBeAPipe) {
  const fs::path out = folder_ / "piped";
  const std::string file = ALPHASCOPE_SOURCE_DIR "/resources/molecules/4hhb.pdb.gz";
  const std::string command = "(zcat '" + file + "' | head -c 100000; sleep 0.1; zcat '" + file +
                              "' | tail -c +100001) | '" ALPHASCOPE_CLI "' info - >'" +
                              out.string() + "'";
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_TRUE(contents(out).starts_with("stdin: used 4,558 of 4,779 atoms"));
}

TEST_F(CliManyFiles, AFormatCanBeNamed) {
  const fs::path table = write("table", "1 0 0 1\n2 0 0 1\n3 0 0 1\n");
  EXPECT_EQ(compute_json("'" + table.string() + "' --alpha 0 --format xyzr")["input"]["format"],
            compute_json("'" + table.string() + "' --alpha 0")["input"]["format"]);
  const Outcome outcome = run("compute - --alpha 0 --format pdb", table);
  EXPECT_EQ(outcome.code, 3) << "it is no PDB file";
  EXPECT_EQ(run("compute - --alpha 0 --format mmcif", kCrambin).code, 3);
  EXPECT_TRUE(contains(run("compute - --alpha 0 --format pdd", kCrambin).err, "mean \"pdb\"?"));
}

}  // namespace
}  // namespace alphascope::testing
