// SPDX-License-Identifier: GPL-3.0-or-later
// Writes frames as numbered pictures, or hands them to a movie file.
#include "ui/scene/picture/frame_sink.hpp"

#include "core/write/movie_file.hpp"

namespace alphascope {
namespace {

class PictureSink : public FrameSink {
 public:
  // Checks that no frame would replace an input file. Checks for the first and the last name
  // whether files can be made there.
  PictureSink(const std::filesystem::path& pattern, int frames, int dpi)
      : names_(pattern), dpi_(dpi) {
    for (int k = 1; k <= frames; ++k) {
      const std::filesystem::path name = names_.name(k);
      refuse_to_replace_input("The picture " + name.string(), name);
    }
    AtomicFile(names_.name(1));
    AtomicFile(names_.name(frames));
  }
  void add(int number, const Image& image, const PictureTexts& texts,
           const RunContext& context) override {
    write_png(image, names_.name(number), texts, context.cancel, dpi_);
  }
  void commit(const RunContext&) override {}

 private:
  FrameNames names_;
  int dpi_;
};

class MovieSink : public FrameSink {
 public:
  MovieSink(const std::filesystem::path& path, const MovieOptions& options)
      : movie_(path, options) {}
  void add(int, const Image& image, const PictureTexts&, const RunContext& context) override {
    movie_.add(image.rgba, context.cancel);
  }
  void commit(const RunContext& context) override { movie_.commit(context.cancel); }

 private:
  MovieFile movie_;
};

// Puts all texts into the comment: ffmpeg's formats do not keep other keywords.
PictureTexts movie_texts(const PictureTexts& texts) {
  std::string comment;
  for (const auto& [keyword, text] : texts) {
    comment += (comment.empty() ? "" : "\n") + keyword + ": " + text;
  }
  return {{"comment", comment}};
}

}  // namespace

std::unique_ptr<FrameSink> make_frame_sink(const std::filesystem::path& path,
                                           const FrameSinkOptions& options) {
  const RecordingFormat format = recording_format(path);
  if (format == RecordingFormat::frames) {
    return std::make_unique<PictureSink>(path, options.frames, options.dpi);
  }
  return std::make_unique<MovieSink>(
      path, MovieOptions{format == RecordingFormat::mp4 ? MovieFormat::mp4 : MovieFormat::webm,
                         options.width, options.height, options.frames_per_second,
                         options.transparent, movie_texts(options.texts)});
}

}  // namespace alphascope
