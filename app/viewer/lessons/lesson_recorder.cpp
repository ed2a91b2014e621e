// SPDX-License-Identifier: GPL-3.0-or-later
// Takes the steps of the recording in the window, and queues their pages for the thread that draws
// and writes. That thread is mostly faster than the window, and waits for pages.
#include "app/viewer/lessons/lesson_recorder.hpp"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <utility>

#include "core/document/picture/frame_names.hpp"
#include "core/files/files_read.hpp"
#include "ui/panels/explain/steps_state.hpp"

namespace alphascope {
namespace {

// Quiet frames before a page is taken: a derived result reaches the picture one frame after it is
// ready.
constexpr int kQuietFrames = 3;
// Greatest number of waiting pages, since each holds whole meshes.
constexpr std::size_t kMostWaiting = 2;

}  // namespace

struct LessonRecorder::Page {
  Picture picture;
  LessonPage words;
};

class LessonRecorder::Pages {
 public:
  explicit Pages(std::size_t count) : count_(count) {}

  std::size_t count() const { return count_; }  // number of all pages of the recording
  bool full() {
    const std::lock_guard lock(mutex_);
    return waiting_.size() >= kMostWaiting;
  }
  void push(Page page) {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(std::move(page));
    changed_.notify_one();
  }
  // Waits for a page. Nothing after the last one. Throws Cancelled.
  std::optional<Page> pop(const CancelToken& cancel) {
    std::unique_lock lock(mutex_);
    while (waiting_.empty()) {
      cancel.throw_if_cancelled();
      if (taken_ == count_) return std::nullopt;
      changed_.wait_for(lock, std::chrono::milliseconds(50));
    }
    Page page = std::move(waiting_.front());
    waiting_.pop_front();
    ++taken_;
    return page;
  }

 private:
  const std::size_t count_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Page> waiting_;
  std::size_t taken_ = 0;
};

LessonRecorder::LessonRecorder(LessonPlayer& player, LessonState& memory, PictureSaver& saver,
                               TakePicture take_picture)
    : player_(player), memory_(memory), saver_(saver), take_picture_(std::move(take_picture)) {}

// The job runs on the thread that saves pictures.
SceneJob LessonRecorder::job(const RecordRequest& request, std::shared_ptr<Pages> pages) {
  const PictureOptions& size = request.options;
  const std::shared_ptr<FrameSink> sink = make_frame_sink(
      request.path,
      {size.width, size.height, kLessonFrameRate, false, {}, static_cast<int>(pages->count())});
  const bool movie = recording_format(request.path) != RecordingFormat::frames;
  const int held = movie ? frames_held(*request.lesson_seconds) : 1;
  return {request.path,
          [=](Scene& scene, const RunContext& context) {
            const RunContext silent{context.cancel, {}};
            std::string lacks;
            int page = 0, frame = 0;
            while (const auto next = pages->pop(context.cancel)) {
              const auto count = static_cast<int>(pages->count());
              ++page;
              context.report("picture " + std::to_string(page) + " of " + std::to_string(count),
                             static_cast<double>(page - 1) / count);
              std::string left_out = next->picture.not_drawn;
              const Image view = marked_image(scene, show(scene, next->picture), left_out, silent);
              const Image image =
                  lesson_picture(view, next->words, size.width, size.height, left_out);
              for (int k = 0; k < held; ++k) {
                sink->add(++frame, image, next->picture.texts, silent);
              }
              if (lacks.empty()) lacks = left_out;
            }
            sink->commit(context);
            return lacks;
          },
          true};
}

void LessonRecorder::start(const RecordRequest& request, Theme theme) {
  if (!memory_.open) throw std::runtime_error("No lesson is open.");
  // Notes the input files of later steps too: no picture may replace them.
  for (const LessonStep& step : memory_.open->steps) {
    note_read(memory_.open->molecule_of(step));
  }
  const auto pages = std::make_shared<Pages>(count_of_parts(*memory_.open));
  saver_.start(job(request, pages));
  pages_ = pages;
  request_ = request;
  theme_ = theme;
  lesson_ = memory_.open;
  step_ = 0;
  answer_ = false;
  quiet_frames_ = 0;
  player_.restart();
}

bool LessonRecorder::undisturbed() const {
  return memory_.open == lesson_ && !memory_.left && memory_.step == step_ &&
         memory_.revealed == answer_;
}

std::string LessonRecorder::step(bool quiet) {
  if (!pages_) return {};
  if (!saver_.busy()) {  // cancelled or failed; PictureSaver tells which
    pages_ = nullptr;
    return {};
  }
  if (!undisturbed()) {
    pages_ = nullptr;
    saver_.cancel();
    return "The recording ended because the lesson was closed or another step was opened. Record "
           "the lesson again.";
  }
  memory_.shown = true;  // the recording takes the text from this column
  memory_.list = false;
  quiet_frames_ = quiet && memory_.ready && !player_.busy() ? quiet_frames_ + 1 : 0;
  if (quiet_frames_ < kQuietFrames || pages_->full()) return {};
  // No work is left, so a part of the picture that is missing now would never come.
  try {
    hand_over();
  } catch (const std::exception& error) {  // for example when memory is too small for the picture
    pages_ = nullptr;
    saver_.cancel();
    return error.what();
  }
  go_on();
  return {};
}

void LessonRecorder::hand_over() {
  ScreenshotRequest request{request_.path, request_.options};
  const PageView view = page_view(request.options.width, request.options.height);
  request.options.width = view.width;
  request.options.height = view.height;
  request.options.background = {};
  const LessonStep& step = lesson_->steps[step_];
  Page page{take_picture_(request), {}};
  page.picture.texts.emplace_back("alphascope:lesson", lesson_->title + ": " + step.title);
  page.words = {
      lesson_->title,
      "step " + std::to_string(step_ + 1) + " of " + std::to_string(lesson_->steps.size()),
      step.title, memory_.paragraphs, theme_};
  pages_->push(std::move(page));
}

// After the last page the thread ends by itself.
void LessonRecorder::go_on() {
  quiet_frames_ = 0;
  const bool asks = lesson_->steps[step_].asks() && !answer_;
  if (!asks && step_ + 1 == lesson_->steps.size()) {
    pages_ = nullptr;
    return;
  }
  answer_ = asks;
  if (!asks) ++step_;
  player_.next();
}

}  // namespace alphascope
