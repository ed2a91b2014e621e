// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the real alphascope-cli in a folder of its own, and reads its output.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace alphascope::testing {

namespace fs = std::filesystem;
using nlohmann::json;

// The program under test. scripts/mutate sets another one.
inline std::string tested_cli() {
  const char* const other = std::getenv("ALPHASCOPE_TESTED_CLI");
  return other != nullptr ? other : ALPHASCOPE_CLI;
}

struct Outcome {
  int code = -1;
  std::string out, err;
};

inline std::string contents(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

// Names and rows of fields, as pandas or R would read them.
inline std::vector<std::map<std::string, std::string>> csv_rows(const std::string& text) {
  std::vector<std::vector<std::string>> lines(1);
  std::string field;
  bool quoted = false;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    if (c == '"') {
      if (quoted && k + 1 < text.size() && text[k + 1] == '"')
        field += text[++k];
      else
        quoted = !quoted;
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

// Whether the program was built with its renderer, which needs neither display nor GPU.
inline constexpr bool kDrawsPictures = ALPHASCOPE_DRAWS_PICTURES != 0;

class Cli : public ::testing::Test {
 protected:
  void SetUp() override {
    ::setenv("ALPHASCOPE_OFFLINE", "1", 1);  // ids in examples of the guide must not be fetched
    std::string pattern = (fs::path(::testing::TempDir()) / "alphascope_cli_XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
    // A cube of eight equal balls. It has every kind of tie, and counts known by hand.
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

  // Runs in folder_, which gets outputs without a folder. `input`: the file for standard input.
  Outcome run(const std::string& arguments, const fs::path& input = "/dev/null") const {
    const fs::path out = folder_ / "stdout", err = folder_ / "stderr";
    const std::string command = "cd '" + folder_.string() + "' && '" + tested_cli() + "' " +
                                arguments + " >'" + out.string() + "' 2>'" + err.string() + "' <'" +
                                input.string() + "'";
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

}  // namespace alphascope::testing
