// SPDX-License-Identifier: GPL-3.0-or-later
// Compares pictures with those in tests/ui/baselines. Whoever changes one of these must look at it.
// ALPHASCOPE_RENEW_BASELINES=1 in the environment writes them again. After a failure, the picture
// and the difference are in tests/ui/pictures of the build folder.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>

#include "tests/ui/scene/picture_difference.hpp"
#include "tests/ui/scene/png_pixels.hpp"
#include "ui/scene/picture/frame_grab.hpp"

namespace alphascope::testing {

// `name`: without ending, perhaps with folders.
inline void expect_like_baseline(const std::string& name, const Image& actual) {
  const std::filesystem::path baseline =
      std::filesystem::path(ALPHASCOPE_SOURCE_DIR) / "tests/ui/baselines" / (name + ".png");
  if (std::getenv("ALPHASCOPE_RENEW_BASELINES") != nullptr) {
    std::filesystem::create_directories(baseline.parent_path());
    write_png(actual, baseline);
    std::cout << "wrote " << baseline << "\n";
    return;
  }
  ASSERT_TRUE(std::filesystem::exists(baseline))
      << "ALPHASCOPE_RENEW_BASELINES=1 writes " << baseline;
  const Image expected = pixels_of(baseline);
  const PictureDifference difference = compare_pictures(actual, expected);
  if (difference.small()) return;
  const std::filesystem::path folder = ALPHASCOPE_PICTURES;
  std::filesystem::create_directories((folder / name).parent_path());
  write_png(actual, folder / (name + ".png"));
  write_png(difference_picture(actual, expected), folder / (name + ".difference.png"));
  ADD_FAILURE() << name << ": " << 100 * difference.share
                << " % of the pixels differ, the shade by " << difference.shade << " of 255. See "
                << folder;
}

}  // namespace alphascope::testing
