// SPDX-License-Identifier: GPL-3.0-or-later
// Tests every file in the data folder's reports, which people had trouble with. Opening ends with
// atoms, or with a message that names the file. The right result for each kind is tested in the
// suite of that kind.
#include <algorithm>
#include <string>
#include <vector>

#include "core/selection/prepare_balls.hpp"
#include "tests/core/files/temporary_file.hpp"

namespace alphascope {
namespace {

std::vector<std::filesystem::path> files_of_reports() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(test_data("reports"))) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

TEST(ReportsFolder, EveryFileGivesAtomsOrAMessageWithItsName) {
  ALPHASCOPE_NEED_TEST_DATA();
  const std::vector<std::filesystem::path> files = files_of_reports();
  ASSERT_GE(files.size(), 380u);
  std::size_t opened = 0;
  for (const std::filesystem::path& file : files) {
    SCOPED_TRACE(file.filename().string());
    try {
      const Molecule m = read_molecule(file);
      ++opened;
      EXPECT_FALSE(m.atoms.empty());
      EXPECT_FALSE(m.models.empty());
      const PreparedBalls prepared = prepare_balls(m);
      EXPECT_LE(prepared.balls->size(), m.atoms.size());
      EXPECT_EQ(prepared.balls->size(), prepared.report.used);
      EXPECT_EQ(prepared.balls->size(), prepared.atom_of_ball.size());
    } catch (const ReadError& error) {
      const std::string said = error.what();
      EXPECT_NE(said.find(file.filename().string()), std::string::npos) << said;
      EXPECT_GT(error.reason().size(), 10u) << said;
      if (error.line() > 0) {
        EXPECT_NE(said.find(std::to_string(error.line())), std::string::npos) << said;
      }
    }
  }
  EXPECT_GE(opened, 300u);
}

}  // namespace
}  // namespace alphascope
