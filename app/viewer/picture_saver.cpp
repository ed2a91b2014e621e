// See the header. VTK keeps nothing that two scenes share while they draw, as long as each scene is
// made on the main thread: there GLEW, which VTK calls OpenGL through, is set up.
#include "app/viewer/picture_saver.hpp"

#include <atomic>
#include <exception>
#include <stdexcept>
#include <utility>

#include "core/molecule/printable.hpp"
#include "ui/window/quiet_context.hpp"

namespace alphascope {

// A context and the scene in it. One for each picture: Mesa's software driver keeps the textures of
// a picture, which can be a gigabyte and more, until its context goes.
struct PictureSaver::Studio {
  explicit Studio(Host& host) : host_(host), context_(host.make_background_context()) {
    context_->make_current();
    try {
      scene_ = std::make_unique<Scene>();
    } catch (...) {
      host_.make_current();
      throw;
    }
    context_->release();
    host_.make_current();
  }
  // On the main thread, when nobody draws any more.
  ~Studio() {
    if (scene_) {
      context_->make_current();
      scene_.reset();
      context_->release();
    }
    context_.reset();
    host_.make_current();
  }

  // Returns and throws as write_picture() does.
  std::string draw(const PictureToSave& p, const RunContext& context) {
    context_->make_current();
    std::string left_out;
    std::exception_ptr failure;
    try {
      scene_->set_style(p.style);
      scene_->set_balls(make_ball_data(p.balls, p.colours, p.radii));
      scene_->set_mesh(make_mesh_data(p.mesh));
      scene_->set_caps(make_cap_data(p.caps));
      scene_->set_differences(make_difference_data(p.differences));
      auto layers = std::make_shared<const LayerMesh>(build_layer_mesh(*p.balls, p.layers));
      scene_->set_layers(make_layer_data(layers));
      scene_->set_beside_body(make_layer_data(p.beside_body));
      scene_->set_viewpoint(p.viewpoint);
      MarkedPicture picture = p.picture;
      picture.labels = layers->labels;
      left_out = write_picture(*scene_, picture, p.path, p.texts, context);
    } catch (...) {
      failure = std::current_exception();
    }
    scene_.reset();
    context_->release();
    if (failure) std::rethrow_exception(failure);
    return left_out;
  }

 private:
  Host& host_;
  std::unique_ptr<BackgroundContext> context_;
  std::unique_ptr<Scene> scene_;
};

PictureSaver::PictureSaver(Host& host, std::function<void()> wake)
    : host_(host), worker_(std::move(wake)) {}

PictureSaver::~PictureSaver() = default;

void PictureSaver::start(PictureToSave picture) {
  if (busy()) {
    throw std::runtime_error("Cannot save " + picture.path.string() + ": " + saving_->string() +
                             " is still being saved. Wait until it is finished, or cancel it.");
  }
  saving_ = picture.path;
  since_ = std::chrono::steady_clock::now();
  waiting_ = std::move(picture);
  begin();
}

// As soon as no cancelled picture is being drawn any more.
void PictureSaver::begin() {
  if (!waiting_ || studio_) return;
  const auto picture = std::make_shared<const PictureToSave>(*std::exchange(waiting_, {}));
  try {
    studio_ = std::make_unique<Studio>(host_);
  } catch (...) {
    saving_.reset();
    throw;
  }
  const auto written = std::make_shared<std::atomic<bool>>(false);
  worker_.submit(
      [this, picture, written, studio = studio_.get()](const RunContext& c) -> Worker::Delivery {
        give_way_to_others();
        const std::string left_out = studio->draw(*picture, c);
        *written = true;
        return [this, picture, left_out] {
          studio_.reset();
          outcome_.ended = true;
          outcome_.notice = "Saved " + printable(picture->path.string());
          if (!left_out.empty()) outcome_.notice += ". " + left_out;
          saving_.reset();
        };
      },
      [this, written, path = picture->path](const Worker::Failure& failure) {
        studio_.reset();
        outcome_.ended = true;
        if (failure.cancelled) {  // which was told already, unless it came too late
          if (*written) outcome_.notice = "Saved " + printable(path.string());
          return;
        }
        const bool names_it = failure.message.find(path.string()) != std::string::npos;
        outcome_.error =
            names_it ? failure.message : "Cannot save " + path.string() + ": " + failure.message;
        saving_.reset();
      });
}

void PictureSaver::cancel() {
  if (!busy()) return;
  outcome_.notice = "Cancelled: " + saving_->string() + " was not written.";
  saving_.reset();
  waiting_.reset();
  worker_.cancel();
}

PictureSaver::Outcome PictureSaver::poll() {
  worker_.poll();
  try {
    begin();
  } catch (const std::exception& error) {
    outcome_.error = error.what();
  }
  return std::exchange(outcome_, {});
}

void PictureSaver::describe(BusyInfo& info) const {
  info = {};
  if (!busy()) return;
  const Worker::Activity activity = worker_.activity();
  info.active = true;
  info.what = "Saving " + saving_->filename().string() +
              (activity.stage.empty() ? "" : ": " + activity.stage);
  info.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - since_).count();
}

}  // namespace alphascope
