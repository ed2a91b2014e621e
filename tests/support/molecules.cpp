// SPDX-License-Identifier: GPL-3.0-or-later
// Reads molecules for tests and makes balls of them.
#include "tests/support/molecules.hpp"

#include "core/read/read_molecule.hpp"
#include "core/selection/prepare_balls.hpp"

namespace alphascope::testing {
namespace {

std::shared_ptr<const BallSet> read_balls(const std::filesystem::path& path,
                                          double solvent_angstrom) {
  const PreparedBalls prepared = prepare_balls(read_molecule(path));
  return std::make_shared<BallSet>(with_solvent(*prepared.balls, solvent_angstrom));
}

}  // namespace

std::filesystem::path test_data_folder() {
  const char* folder = std::getenv("ALPHASCOPE_TEST_DATA");
  return folder != nullptr && *folder != '\0' ? folder : ALPHASCOPE_TEST_DATA;
}

bool test_data_is_required() {
  const char* required = std::getenv("ALPHASCOPE_TEST_DATA_REQUIRED");
  return required != nullptr && *required != '\0';
}

std::shared_ptr<const BallSet> molecule_balls(const std::string& file, double solvent_angstrom) {
  const std::filesystem::path folder = test_data_folder();
  if (folder.empty()) return nullptr;
  return read_balls(folder / file, solvent_angstrom);
}

std::shared_ptr<const BallSet> sample_balls(const std::string& file, double solvent_angstrom) {
  const std::filesystem::path root = ALPHASCOPE_SOURCE_DIR;
  return read_balls(root / "resources" / "molecules" / file, solvent_angstrom);
}

}  // namespace alphascope::testing
