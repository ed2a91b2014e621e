// SPDX-License-Identifier: GPL-3.0-or-later
// A stand-in for ffmpeg in front of PATH, for tests that must not depend on the installed ffmpeg.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace alphascope::testing {

// While this object lives, `ffmpeg` is this shell script. $file is the movie to be written. Empty:
// there is no ffmpeg.
class FakeFfmpeg {
 public:
  FakeFfmpeg(const std::filesystem::path& folder, const std::string& script) {
    const char* const path = std::getenv("PATH");
    before_ = path == nullptr ? "" : path;
    const std::filesystem::path bin = folder / "bin";
    std::filesystem::create_directories(bin);
    if (!script.empty()) {
      const std::filesystem::path program = bin / "ffmpeg";
      std::ofstream(program) << "#!/bin/sh\nPATH='" << before_
                             << "'\nfor file; do :; done\nfile=${file#file:}\n"
                             << script << "\n";
      std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    }
    ::setenv("PATH", bin.c_str(), 1);
  }
  ~FakeFfmpeg() { ::setenv("PATH", before_.c_str(), 1); }
  FakeFfmpeg(const FakeFfmpeg&) = delete;
  FakeFfmpeg& operator=(const FakeFfmpeg&) = delete;

 private:
  std::string before_;
};

}  // namespace alphascope::testing
