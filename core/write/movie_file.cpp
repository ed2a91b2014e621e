// SPDX-License-Identifier: GPL-3.0-or-later
// Sends frames to ffmpeg. An MP4 file is not written from front to back. So ffmpeg writes to the
// temporary file of an AtomicFile.
#include "core/write/movie_file.hpp"

#include <cstdint>
#include <stdexcept>

#include "core/geometry/shortest_number.hpp"
#include "core/run/child_program.hpp"

namespace alphascope {
namespace {

struct Codec {
  const char* format;  // ffmpeg's name for it
  const char* name;
  std::vector<std::string> options;
};

Codec codec_of(const MovieOptions& o) {
  if (o.format == MovieFormat::mp4) {
    return {"mp4",
            "libx264",
            {"-crf", "18", "-preset", "medium", "-pix_fmt", "yuv420p", "-movflags", "+faststart"}};
  }
  return {"webm",
          "libvpx-vp9",
          {"-crf", "24", "-b:v", "0", "-row-mt", "1", "-auto-alt-ref", "0", "-pix_fmt",
           o.transparent ? "yuva420p" : "yuv420p"}};
}

std::filesystem::path ffmpeg() {
  if (const auto program = find_program("ffmpeg")) return *program;
  throw WriteError(
      "The program makes movies with ffmpeg, which is not on PATH. Install it (Debian: apt install "
      "ffmpeg), or write numbered pictures instead, such as frame-%04d.png.");
}

std::vector<std::string> arguments(const MovieOptions& o) {
  const Codec codec = codec_of(o);
  std::vector<std::string> words{
      "-hide_banner", "-nostdin",
      "-loglevel",    "error",
      "-xerror",      "-y",
      "-f",           "rawvideo",
      "-pix_fmt",     "rgba",
      "-s",           std::to_string(o.width) + "x" + std::to_string(o.height),
      "-r",           shortest_number(o.frames_per_second),
      "-i",           "pipe:0",
      "-vf",          "pad=ceil(iw/2)*2:ceil(ih/2)*2",
      "-c:v",         codec.name};
  words.insert(words.end(), codec.options.begin(), codec.options.end());
  for (const auto& [keyword, text] : o.texts) {
    words.insert(words.end(), {"-metadata", keyword + "=" + text});
  }
  // The file that is already open here. With its name, ffmpeg could create it again after its
  // removal.
  words.insert(words.end(),
               {"-f", codec.format, "file:/proc/self/fd/" + std::to_string(kChildFile)});
  return words;
}

// The last line, which has the reason of a failure.
std::string last_line(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
  return text.substr(text.find_last_of("\r\n") + 1);
}

}  // namespace

struct MovieFile::Parts {
  std::string name;
  MovieOptions options;
  AtomicFile file;
  ChildProgram program;

  Parts(const std::filesystem::path& path, const MovieOptions& o,
        const std::filesystem::path& ffmpeg)
      : name(path.string()), options(o), file(path), program(ffmpeg, arguments(o), temporary()) {}

  int temporary() const {
    if (file.descriptor_of_temporary() >= 0) return file.descriptor_of_temporary();
    throw WriteError("Cannot write a movie to " + name +
                     ": it is no ordinary file. Give the name of one.");
  }
};

void require_ffmpeg() {
  static_cast<void>(ffmpeg());
}

MovieFile::MovieFile(const std::filesystem::path& path, const MovieOptions& options) {
  if (options.transparent && options.format == MovieFormat::mp4) {
    throw std::invalid_argument(
        "An .mp4 movie always has a background. Choose .webm or numbered pictures, or leave out "
        "the transparency.");
  }
  parts_ = std::make_unique<Parts>(path, options, ffmpeg());
}

MovieFile::~MovieFile() = default;

void MovieFile::fail() const {
  const std::string said = last_line(parts_->program.error_output());
  throw WriteError("Cannot write " + parts_->name + ": ffmpeg could not make it with the codec " +
                   codec_of(parts_->options).name + (said.empty() ? "" : ": " + said) +
                   ". Check free space and the codecs of this ffmpeg (ffmpeg -encoders), or write "
                   "numbered pictures instead, such as frame-%04d.png.");
}

void MovieFile::add(std::span<const std::uint8_t> rgba, const CancelToken& cancel) {
  if (parts_->program.write(rgba, cancel)) return;
  parts_->program.finish(cancel);  // all of its messages have arrived then
  fail();
}

void MovieFile::commit(const CancelToken& cancel) {
  // ffmpeg 5.1 exits with 0 even if the disk was full. It is started so that it prints errors only.
  const bool refused = parts_->program.finish(cancel) != 0;
  if (refused || !parts_->program.error_output().empty()) fail();
  cancel.throw_if_cancelled();
  parts_->file.commit();
}

}  // namespace alphascope
