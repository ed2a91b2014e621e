// SPDX-License-Identifier: GPL-3.0-or-later
// Small input files that tests write, and the messages of refused ones.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "core/read/read_molecule.hpp"
#include "tests/support/molecules.hpp"

namespace alphascope {

class TemporaryFile {
 public:
  TemporaryFile(const std::string& name, std::string_view content) {
    static int count = 0;
    folder_ = std::filesystem::temp_directory_path() /
              ("alphascope-test-" + std::to_string(getpid()) + "-" + std::to_string(count++));
    std::filesystem::create_directories(folder_);
    path_ = folder_ / name;
    std::ofstream(path_, std::ios::binary) << content;
  }
  ~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path folder_, path_;
};

inline Molecule read_text(const std::string& name, std::string_view content) {
  const TemporaryFile file(name, content);
  return read_molecule(file.path());
}

// The error from reading this text. The test fails when there is none.
inline ReadError refusal(const std::string& name, std::string_view content,
                         const ReadOptions& options = {}) {
  const TemporaryFile file(name, content);
  try {
    read_molecule(file.path(), options);
  } catch (const ReadError& error) {
    return error;
  }
  ADD_FAILURE() << "no error for " << name << ": " << content.substr(0, 200);
  return ReadError("", 0, "", "");
}

inline std::filesystem::path test_data(const std::string& name) {
  return testing::test_data_folder() / name;
}

}  // namespace alphascope
