// Saves pictures of the view while the window goes on: a thread of its own draws them, in an OpenGL
// context and a scene of their own, and writes the file. The window's thread only starts it.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/run/worker.hpp"
#include "ui/panels/view_info.hpp"
#include "ui/scene/draw_marks.hpp"
#include "ui/scene/scene.hpp"
#include "ui/window/host.hpp"

namespace alphascope {

// All that a picture is made of. What is shared with the window never changes.
struct PictureToSave {
  std::shared_ptr<const BallGeometry> balls;
  std::vector<Rgb8> colours;                          // one a ball
  std::vector<float> radii;                           // Å, as drawn; one a ball
  std::shared_ptr<const ComplexMesh> mesh;            // null: none
  std::shared_ptr<const CapMesh> caps;                // null: none
  std::shared_ptr<const DifferenceMesh> differences;  // null: none
  Layers layers;
  std::shared_ptr<const LayerMesh> beside_body;  // null: none
  SceneStyle style;
  Viewpoint viewpoint;
  MarkedPicture picture;
  PictureTexts texts;
  std::filesystem::path path;
};

class PictureSaver {
 public:
  // `wake` as in Worker. The host's context is the one that is current between these calls.
  PictureSaver(Host& host, std::function<void()> wake);
  ~PictureSaver();

  // One at a time: throws std::runtime_error while another picture is being saved, or when OpenGL
  // has no second context.
  void start(PictureToSave picture);
  // At once, as far as anybody sees: the file stays as it was. The thread ends when it can.
  void cancel();
  bool busy() const { return saving_.has_value(); }

  // What happened since the last call, on the main thread.
  struct Outcome {
    std::string notice;  // a picture was saved, or was not because of cancel()
    std::string error;   // why it could not be saved
    bool ended = false;  // a drawing did, also a cancelled one: its memory is free
    bool any() const { return ended || !notice.empty() || !error.empty(); }
  };
  Outcome poll();
  // Fills `info` for the line of progress.
  void describe(BusyInfo& info) const;

 private:
  struct Studio;
  void begin();

  Host& host_;
  std::optional<std::filesystem::path> saving_;  // not cancelled
  std::optional<PictureToSave> waiting_;         // for a cancelled one to end
  std::chrono::steady_clock::time_point since_;
  Outcome outcome_;
  std::unique_ptr<Studio> studio_;  // of the picture that is being drawn; destroyed here only
  Worker worker_;                   // last: joined first
};

}  // namespace alphascope
