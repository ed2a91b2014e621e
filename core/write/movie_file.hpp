// SPDX-License-Identifier: GPL-3.0-or-later
// A movie made of pictures by the program ffmpeg. The file appears under its name only when it is
// complete.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/files/atomic_file.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

enum class MovieFormat : std::uint8_t { mp4, webm };

struct MovieOptions {
  MovieFormat format = MovieFormat::mp4;
  // Pixels; the codecs need even numbers, so odd sizes are padded by one.
  int width = 0, height = 0;
  double frames_per_second = 30;
  bool transparent = false;                                // webm only
  std::vector<std::pair<std::string, std::string>> texts;  // metadata of the file: keyword and text
};

// Throws WriteError with the remedy if ffmpeg is not on PATH.
void require_ffmpeg();

class MovieFile {
 public:
  // Throws WriteError, also if there is no ffmpeg. Throws std::invalid_argument, with a sentence,
  // for options that the format does not support.
  MovieFile(const std::filesystem::path& path, const MovieOptions& options);
  ~MovieFile();  // without commit() an older file stays, and ffmpeg is ended
  MovieFile(const MovieFile&) = delete;
  MovieFile& operator=(const MovieFile&) = delete;

  // Adds a picture of the movie's size: 4 bytes (red, green, blue, alpha) per pixel, top row first.
  // Throws WriteError with ffmpeg's message if it has given up, and Cancelled.
  void add(std::span<const std::uint8_t> rgba, const CancelToken& cancel);
  void commit(const CancelToken& cancel);  // throws as add()

 private:
  struct Parts;
  [[noreturn]] void fail() const;
  std::unique_ptr<Parts> parts_;
};

}  // namespace alphascope
