// Saves pictures and recordings of the view while the window goes on: a thread of its own draws
// them, in an OpenGL context and a scene of their own, and writes the file. The window's thread
// only starts it.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/run/worker.hpp"
#include "ui/panels/dialogs/picture_memory.hpp"
#include "ui/panels/view_info.hpp"
#include "ui/scene/picture/picture.hpp"
#include "ui/scene/picture/record_frames.hpp"
#include "ui/window/host.hpp"

namespace alphascope {

struct PictureToSave : Picture {
  std::filesystem::path path;
};

// Pictures are drawn and written in it; returns what they lack, in sentences.
struct SceneJob {
  std::filesystem::path path;
  std::function<std::string(Scene& scene, const RunContext& context)> draw;
  bool recording = false;
};
SceneJob picture_job(PictureToSave picture);
// `texts`: of a movie as a whole. Throws std::invalid_argument, a sentence, for a request that
// cannot be; WriteError where the file cannot be begun.
SceneJob recording_job(const RecordRequest& request, FrameSource source, PictureTexts texts);

class PictureSaver {
 public:
  // `wake` as in Worker. The host's context is the one that is current between these calls.
  PictureSaver(Host& host, std::function<void()> wake);
  ~PictureSaver();

  // One at a time: throws std::runtime_error while another job is being done, or when OpenGL has no
  // second context.
  void start(SceneJob job);
  // At once, as far as anybody sees: the file stays as it was, and finished frames of a recording
  // stay. The thread ends when it can.
  void cancel();
  bool busy() const { return saving_.has_value(); }

  // What happened since the last call, on the main thread.
  struct Outcome {
    std::string notice;         // a picture was saved, or was not because of cancel()
    std::string error;          // why it could not be saved
    bool of_recording = false;  // the error is
    bool ended = false;         // a drawing did, also a cancelled one: its memory is free
    bool any() const { return ended || !notice.empty() || !error.empty(); }
  };
  Outcome poll();
  // Fills `info` for the line of progress.
  void describe(BusyInfo& info) const;

 private:
  struct Studio;
  void begin();

  Host& host_;
  struct Saving {
    std::filesystem::path path;
    bool recording = false;
  };
  std::optional<Saving> saving_;     // not cancelled
  std::optional<SceneJob> waiting_;  // for a cancelled one to end
  std::chrono::steady_clock::time_point since_;
  Outcome outcome_;
  std::unique_ptr<Studio> studio_;  // of the picture that is being drawn; destroyed here only
  Worker worker_;                   // last: joined first
};

}  // namespace alphascope
