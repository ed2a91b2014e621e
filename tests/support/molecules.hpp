// SPDX-License-Identifier: GPL-3.0-or-later
// Balls of the program's sample molecules, and of large test molecules outside the repository.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>

#include "core/geometry/ball_set.hpp"

namespace alphascope::testing {

// The data folder: the environment variable ALPHASCOPE_TEST_DATA, or else the CMake cache variable
// of that name. Empty when neither is set.
std::filesystem::path test_data_folder();

// Balls of a sample molecule of the program ("1crn.pdb"), which is always there.
std::shared_ptr<const BallSet> sample_balls(const std::string& file, double solvent_angstrom = 0);

// Balls of a file in the data folder ("thesis/1k4c.crd.gz"), grown by the solvent radius (Å).
// Selection and radii are the default. Null when no folder is set. Throws when the folder has no
// such file.
std::shared_ptr<const BallSet> molecule_balls(const std::string& file, double solvent_angstrom = 0);

// True when the environment variable ALPHASCOPE_TEST_DATA_REQUIRED is set, as by .ci/run.
bool test_data_is_required();

// Skips the running test without a data folder. Fails it where the folder is required.
#define ALPHASCOPE_NEED_TEST_DATA()                                               \
  if (::alphascope::testing::test_data_folder().empty()) {                        \
    if (::alphascope::testing::test_data_is_required()) {                         \
      GTEST_FAIL() << "ALPHASCOPE_TEST_DATA_REQUIRED is set, but no data folder"; \
    }                                                                             \
    GTEST_SKIP() << "set ALPHASCOPE_TEST_DATA to the folder of molecules";        \
  }

}  // namespace alphascope::testing
