// Jobs of PictureSaver, and the context and scene for each. Two VTK scenes share nothing while they
// draw, if both were created on the main thread. GLEW, VTK's access to OpenGL, is set up there.
#include "app/viewer/jobs/picture_saver.hpp"

#include <exception>
#include <stdexcept>
#include <utility>

#include "core/files/atomic_file.hpp"
#include "core/run/background.hpp"
#include "core/text/printable.hpp"

namespace alphascope {

// An OpenGL context and the scene in it, for one job. Mesa's software driver keeps the textures of
// a picture, which can exceed a gigabyte, until the context is destroyed.
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
  // Call on the main thread, when no thread draws in this context.
  ~Studio() {
    if (scene_) {
      context_->make_current();
      scene_.reset();
      context_->release();
    }
    context_.reset();
    host_.make_current();
  }

  // Returns and throws as job.draw does.
  std::string draw(const SceneJob& job, const RunContext& context) {
    context_->make_current();
    std::string left_out;
    std::exception_ptr failure;
    try {
      left_out = job.draw(*scene_, context);
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

SceneJob picture_job(PictureToSave picture) {
  std::filesystem::path path = picture.path;
  const auto shared = std::make_shared<const PictureToSave>(std::move(picture));
  return {std::move(path), [shared](Scene& scene, const RunContext& context) {
            return write_picture(scene, show(scene, *shared), shared->path, shared->texts, context);
          }};
}

SceneJob recording_job(const RecordRequest& request, FrameSource source, PictureTexts texts) {
  const Recording& recording = request.recording;
  if (const std::string fault = fault_of(recording); !fault.empty()) {
    throw std::invalid_argument(fault);
  }
  // These texts describe one complex, and a sweep has many.
  std::erase_if(texts, [&](const auto& text) {
    return recording.kind == RecordingKind::sweep &&
           (text.first.starts_with("alphascope:alpha") || text.first == "alphascope:hash");
  });
  const std::shared_ptr<FrameSink> sink = make_frame_sink(
      request.path, {request.options.width, request.options.height, recording.frames_per_second,
                     request.options.transparent, std::move(texts), frame_count(recording)});
  return {request.path,
          [sink, recording, source = std::move(source)](Scene& scene, const RunContext& context) {
            std::string lacks = record_frames(scene, recording, source, *sink, context);
            sink->commit(context);
            return lacks;
          },
          true};
}

void PictureSaver::start(SceneJob job) {
  if (busy()) {
    throw std::runtime_error("Cannot save " + job.path.string() + ": " + saving_->path.string() +
                             " is still being saved. Wait until it is finished, or cancel it.");
  }
  // An unwritable path must fail before the drawing. A recording has already opened its files.
  if (!job.recording) AtomicFile{job.path};
  saving_ = Saving{job.path, job.recording};
  since_ = std::chrono::steady_clock::now();
  waiting_ = std::move(job);
  begin();
}

// Starts the waiting job if no cancelled job is still drawing.
void PictureSaver::begin() {
  if (!waiting_ || studio_) return;
  const auto job = std::make_shared<const SceneJob>(*std::exchange(waiting_, {}));
  try {
    studio_ = std::make_unique<Studio>(host_);
  } catch (...) {
    outcome_.of_recording = job->recording;
    saving_.reset();
    throw;
  }
  worker_.submit(
      [this, job, studio = studio_.get()](const RunContext& c) -> Worker::Delivery {
        give_way_to_others(Share::third);
        const std::string left_out = studio->draw(*job, c);
        return [this, job, left_out] {
          studio_.reset();
          outcome_.ended = true;
          outcome_.notice = "Saved " + printable(job->path.string());
          if (!left_out.empty()) outcome_.notice += ". " + left_out;
          saving_.reset();
        };
      },
      [this, path = job->path, recording = job->recording](const Worker::Failure& failure) {
        studio_.reset();
        outcome_.ended = true;
        if (failure.cancelled) {  // the user knows already, unless cancel() came too late
          if (failure.too_late) outcome_.notice = "Saved " + printable(path.string());
          return;
        }
        const bool names_it = failure.message.find(path.string()) != std::string::npos;
        outcome_.error =
            names_it ? failure.message : "Cannot save " + path.string() + ": " + failure.message;
        outcome_.of_recording = recording;
        saving_.reset();
      });
}

void PictureSaver::cancel() {
  if (!busy()) return;
  outcome_.notice = saving_->recording && recording_format(saving_->path) == RecordingFormat::frames
                        ? "Cancelled: the frames that were finished are there."
                        : "Cancelled: " + saving_->path.string() + " was not written.";
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
  info.what = (saving_->recording ? "Recording " : "Saving ") + saving_->path.filename().string();
  info.step = activity.stage;
  info.share = activity.share > 0 ? activity.share : -1;
  info.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - since_).count();
}

}  // namespace alphascope
