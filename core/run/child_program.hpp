// SPDX-License-Identifier: GPL-3.0-or-later
// Runs another program and writes to its standard input. The program never outlives this object.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace alphascope {

class CancelToken;

// Looks for a program on PATH; empty if it is not installed.
std::optional<std::filesystem::path> find_program(std::string_view name);

inline constexpr int kChildFile = 3;

class ChildProgram {
 public:
  // Starts the program in its own process group, so that Ctrl+C in a terminal reaches the caller
  // only. Its standard output is discarded. It gets the open descriptor `file` as its descriptor
  // kChildFile; -1: none. Throws std::runtime_error with a sentence.
  ChildProgram(const std::filesystem::path& program, const std::vector<std::string>& arguments,
               int file = -1);
  ~ChildProgram();  // kills the program if it still runs
  ChildProgram(const ChildProgram&) = delete;
  ChildProgram& operator=(const ChildProgram&) = delete;

  // Waits until the program has taken all bytes. False if it has ended and takes no more. Throws
  // Cancelled.
  bool write(std::span<const std::uint8_t> bytes, const CancelToken& cancel);
  // Closes its input and waits for its end. Returns its exit status, or 128 + the number of the
  // signal. Throws Cancelled.
  int finish(const CancelToken& cancel);
  // The text that it has written to standard error, at most the last `most` bytes.
  std::string error_output(std::size_t most = 2000) const;

 private:
  void close_input();
  int reap(int options);

  int input_ = -1, errors_ = -1;
  int process_ = -1;
};

// Kills the programs of all ChildPrograms and waits at most a second for their end. For a signal
// handler that ends the program: it makes only calls that are allowed there.
void kill_child_programs() noexcept;

}  // namespace alphascope
