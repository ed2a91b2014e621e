// Another program that is fed through its standard input. It never outlives this object.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/run/cancel_token.hpp"

namespace alphascope {

// On PATH; none: it is not installed.
std::optional<std::filesystem::path> find_program(std::string_view name);

inline constexpr int kChildFile = 3;

class ChildProgram {
 public:
  // In a process group of its own, so that Ctrl+C in a terminal reaches the caller alone, who then
  // decides. Its standard output is thrown away. It gets `file`, an open descriptor, as its
  // descriptor kChildFile; -1: none. Throws std::runtime_error, a sentence.
  ChildProgram(const std::filesystem::path& program, const std::vector<std::string>& arguments,
               int file = -1);
  ~ChildProgram();  // kills it if it still runs
  ChildProgram(const ChildProgram&) = delete;
  ChildProgram& operator=(const ChildProgram&) = delete;

  // Waits until it has taken all. False: it takes no more, since it has ended. Throws Cancelled.
  bool write(std::span<const std::uint8_t> bytes, const CancelToken& cancel);
  // Ends its input and waits. Its exit status, or 128 and its signal. Throws Cancelled.
  int finish(const CancelToken& cancel);
  // What it has written to standard error, at most this much of the end.
  std::string said(std::size_t most = 2000) const;

 private:
  void close_input();
  int reap(int options);

  int input_ = -1, errors_ = -1;
  int process_ = -1;
};

// Kills those of all ChildPrograms and waits for their end, a second at most. For a signal handler
// that ends the program: calls only what is allowed there.
void kill_child_programs() noexcept;

}  // namespace alphascope
