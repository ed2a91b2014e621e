// Balls of the program's sample molecules, and of the large test molecules that are not part of the
// repository.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>

#include "core/geometry/ball_set.hpp"

namespace alphascope::testing {

// The data folder: the environment variable ALPHASCOPE_TEST_DATA, else the CMake cache variable of
// the same name; empty when neither is set.
std::filesystem::path test_data_folder();

// Balls of a sample molecule of the program ("1crn.pdb"), which is always there.
std::shared_ptr<const BallSet> sample_balls(const std::string& file, double solvent_angstrom = 0);

// Balls of a file of the data folder ("thesis/1k4c.crd.gz"), default selection and radii, grown by
// the solvent radius (Å). Null when the folder is not set; throws when it is and the file is not
// there.
std::shared_ptr<const BallSet> molecule_balls(const std::string& file, double solvent_angstrom = 0);

// Whether the environment variable ALPHASCOPE_TEST_DATA_REQUIRED is set, as by .ci/run.
bool test_data_is_required();

// Skips the running test when there is no data folder; fails it where there must be one.
#define ALPHASCOPE_NEED_TEST_DATA()                                               \
  if (::alphascope::testing::test_data_folder().empty()) {                        \
    if (::alphascope::testing::test_data_is_required()) {                         \
      GTEST_FAIL() << "ALPHASCOPE_TEST_DATA_REQUIRED is set, but no data folder"; \
    }                                                                             \
    GTEST_SKIP() << "set ALPHASCOPE_TEST_DATA to the folder of molecules";        \
  }

}  // namespace alphascope::testing
