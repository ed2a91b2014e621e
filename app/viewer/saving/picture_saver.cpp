// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the jobs of PictureSaver, each with an OpenGL context and a scene of its own. GLEW, through
// which VTK calls OpenGL, must be set up on the main thread, so scenes are created there. After
// that two scenes share nothing while they draw.
#include "app/viewer/saving/picture_saver.hpp"

#include <exception>
#include <stdexcept>
#include <utility>

#include "app/viewer/saving/picture_clipboard.hpp"
#include "core/files/atomic_file.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/run/thread_priority.hpp"
#include "core/text/printable.hpp"
#include "ui/panels/explain/steps_state.hpp"
#include "ui/panels/failure_kind.hpp"
#include "ui/running_job.hpp"

namespace alphascope {
namespace {

std::string done(const SceneJob& job) {
  return job.copies ? "Copied the picture" : "Saved " + printable(job.path.string());
}

const char* title_of_failure(const SceneJob& job) {
  return job.copies ? kNoCopy : job.recording ? kNoRecording : kNoPicture;
}

}  // namespace

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
  if (path.empty()) {
    return {{},
            [shared, clipboard = picture_clipboard()](Scene& scene, const RunContext& context) {
              std::string left_out;
              const std::string png =
                  picture_bytes(scene, show(scene, *shared), shared->texts, left_out, context);
              context.report("copying", 0);
              copy_picture(clipboard, png, context.cancel);
              return left_out;
            },
            false,
            true};
  }
  return {std::move(path), [shared](Scene& scene, const RunContext& context) {
            return write_picture(scene, show(scene, *shared), shared->path, shared->texts, context);
          }};
}

SceneJob recording_job(const RecordRequest& request, FrameSource source, PictureTexts texts) {
  const Recording& recording = request.recording;
  if (const std::string fault = fault_of(recording); !fault.empty()) {
    throw std::invalid_argument(fault);
  }
  // Leaves out texts that describe one complex, since a sweep has many.
  std::erase_if(texts, [&](const auto& text) {
    return recording.kind == RecordingKind::sweep &&
           (text.first.starts_with("alphascope:alpha") || text.first == "alphascope:hash");
  });
  const std::shared_ptr<FrameSink> sink = make_frame_sink(
      request.path, {request.options.width, request.options.height, recording.frames_per_second,
                     request.options.background.transparent, std::move(texts),
                     frame_count(recording), request.options.dpi});
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
    throw std::runtime_error(
        (job.copies ? "Cannot copy the picture" : "Cannot save " + job.path.string()) + ": " +
        (saving_->copies ? "a picture is still being copied"
                         : saving_->path.string() + " is still being saved") +
        ". Wait until it is finished, or cancel it.");
  }
  // An unwritable path must fail before the drawing. A recording has already opened its files.
  if (!job.recording && !job.copies) AtomicFile{job.path};
  saving_ = Saving{job.path, job.recording, job.copies};
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
    saving_.reset();
    throw;
  }
  worker_.submit(
      [this, job, studio = studio_.get()](const RunContext& c) -> Worker::Delivery {
        lower_thread_priority(CpuShare::third);
        const std::string left_out = studio->draw(*job, c);
        return [this, job, left_out] {
          studio_.reset();
          news_.frees_memory = true;
          news_.notice = done(*job);
          news_.saved = job->path;
          if (!left_out.empty()) news_.notice += ". " + left_out;
          saving_.reset();
        };
      },
      [this, job](const Worker::Failure& failure) {
        studio_.reset();
        news_.frees_memory = true;
        if (failure.cancelled) {  // the user knows, unless cancel() came too late
          if (failure.too_late) {
            news_.notice = done(*job);
            news_.saved = job->path;
          }
          return;
        }
        const std::filesystem::path& path = job->path;
        const bool names_it =
            job->copies || failure.message.find(path.string()) != std::string::npos;
        news_.error_title = title_of_failure(*job);
        news_.error = names_it ? failure.message
                               : "Cannot save " + printable(path.string()) + ": " + failure.message;
        news_.error_kind = kind_of(failure.cause, ErrorKind::computing);
        saving_.reset();
      });
}

void PictureSaver::cancel() {
  if (!busy()) return;
  news_.notice = saving_->recording && recording_format(saving_->path) == RecordingFormat::frames
                     ? "Cancelled. The finished frames are kept."
                 : saving_->copies ? "Cancelled: the picture was not copied."
                                   : "Cancelled: " + saving_->path.string() + " was not written.";
  saving_.reset();
  waiting_.reset();
  worker_.cancel();
}

JobNews PictureSaver::poll() {
  worker_.poll();
  const char* const title = waiting_ ? title_of_failure(*waiting_) : kNoPicture;
  try {
    begin();
  } catch (const std::exception& error) {
    news_.error_title = title;
    news_.error = error.what();
    news_.error_kind = kind_of(error, ErrorKind::computing);
  }
  return std::exchange(news_, {});
}

std::optional<RunningJob> PictureSaver::running() const {
  if (!saving_) return std::nullopt;
  return running_job(JobId::picture,
                     saving_->copies ? "Copying the picture"
                                     : (saving_->recording ? "Recording " : "Saving ") +
                                           saving_->path.filename().string(),
                     worker_.activity(), since_);
}

}  // namespace alphascope
