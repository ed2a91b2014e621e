// A movie of pictures, which the program ffmpeg packs. Its name never shows half of one.
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
  int width = 0, height = 0;  // pixels; odd ones get a row or column more, which the codecs want
  double frames_per_second = 30;
  bool transparent = false;                                // webm only
  std::vector<std::pair<std::string, std::string>> texts;  // keyword and text, into the file
};

// Throws WriteError with the remedy where there is no ffmpeg on PATH.
void require_ffmpeg();

class MovieFile {
 public:
  // Throws WriteError, also when ffmpeg is not there; std::invalid_argument, a sentence, for what
  // the format cannot.
  MovieFile(const std::filesystem::path& path, const MovieOptions& options);
  ~MovieFile();  // without commit() an older file stays, and ffmpeg is ended
  MovieFile(const MovieFile&) = delete;
  MovieFile& operator=(const MovieFile&) = delete;

  // Of the movie's size: 4 bytes (red, green, blue, alpha) a pixel, top row first. Throws
  // WriteError when ffmpeg has given up, with what it said; Cancelled.
  void add(std::span<const std::uint8_t> rgba, const CancelToken& cancel);
  void commit(const CancelToken& cancel);  // the same

 private:
  struct Parts;
  [[noreturn]] void fail() const;
  std::unique_ptr<Parts> parts_;
};

}  // namespace alphascope
