// SPDX-License-Identifier: GPL-3.0-or-later
// Saves pictures and recordings of the view in the background. A thread draws them in an OpenGL
// context and a scene of its own, and writes the files.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/viewer/jobs/job_list.hpp"
#include "core/run/worker.hpp"
#include "ui/panels/dialogs/picture_requests.hpp"
#include "ui/scene/picture/picture.hpp"
#include "ui/scene/picture/record_frames.hpp"
#include "ui/window/host.hpp"

namespace alphascope {

// Titles of the dialogs that report a failure.
inline constexpr const char* kNoPicture = "The picture cannot be saved";
inline constexpr const char* kNoRecording = "The recording cannot be made";
inline constexpr const char* kNoCopy = "The picture cannot be copied";

struct PictureToSave : Picture {
  std::filesystem::path path;
};

// A job that draws pictures in a scene and writes them. `draw` returns what the pictures lack, in
// sentences.
struct SceneJob {
  std::filesystem::path path;
  std::function<std::string(Scene& scene, const RunContext& context)> draw;
  bool recording = false;
  bool copies = false;  // to the clipboard; then `path` is empty
};
// With an empty path the picture goes to the clipboard. Throws as picture_clipboard() does.
SceneJob picture_job(PictureToSave picture);
// `texts` describe the whole movie. Throws std::invalid_argument (a sentence) for an impossible
// request, and WriteError where the file cannot be created.
SceneJob recording_job(const RecordRequest& request, FrameSource source, PictureTexts texts);

class PictureSaver : public ViewerJob {
 public:
  // `wake` as in Worker. The host's own context must be current at each call.
  PictureSaver(Host& host, std::function<void()> wake);
  ~PictureSaver() override;

  // Starts one job. Throws std::runtime_error while another job runs, or if OpenGL gives no second
  // context.
  void start(SceneJob job);
  // Cancels the job. It disappears from the list at once, and its thread ends later. An older file
  // stays as it was, and finished frames of a recording stay.
  void cancel() override;
  bool busy() const { return saving_.has_value(); }

  std::optional<RunningJob> running() const override;
  JobNews poll() override;

 private:
  struct Studio;
  void begin();

  Host& host_;
  struct Saving {
    std::filesystem::path path;
    bool recording = false, copies = false;
  };
  std::optional<Saving> saving_;     // the job that is not cancelled
  std::optional<SceneJob> waiting_;  // waits for the end of a cancelled job
  std::chrono::steady_clock::time_point since_;
  JobNews news_;
  std::unique_ptr<Studio> studio_;  // draws the running job; destroyed on the main thread only
  Worker worker_;                   // last member, so that its thread is joined first
};

}  // namespace alphascope
