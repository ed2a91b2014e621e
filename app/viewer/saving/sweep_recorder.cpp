// SPDX-License-Identifier: GPL-3.0-or-later
// The steps of a sweep in the window, and the exchange of alphas and pictures with the drawing
// thread.
#include "app/viewer/saving/sweep_recorder.hpp"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <utility>

#include "core/geometry/alpha.hpp"

namespace alphascope {
namespace {

// Frames without other work before a picture is taken. A derived result reaches the picture one
// frame after it is ready.
constexpr int kQuietFrames = 3;

}  // namespace

class SweepRecorder::Exchange {
 public:
  // Call on the drawing thread: waits for the picture of this alpha. Throws Cancelled.
  Picture picture_of(const Alpha& alpha, const CancelToken& cancel) {
    std::unique_lock lock(mutex_);
    wanted_ = alpha;
    while (!picture_) {
      cancel.throw_if_cancelled();
      given_.wait_for(lock, std::chrono::milliseconds(50));
    }
    wanted_.reset();
    return *std::exchange(picture_, std::nullopt);
  }

  std::optional<Alpha> wanted() {
    const std::lock_guard lock(mutex_);
    return picture_ ? std::nullopt : wanted_;
  }
  void give(Picture picture) {
    const std::lock_guard lock(mutex_);
    picture_ = std::move(picture);
    given_.notify_one();
  }

 private:
  std::mutex mutex_;
  std::condition_variable given_;
  std::optional<Alpha> wanted_;
  std::optional<Picture> picture_;
};

SweepRecorder::SweepRecorder(PictureSaver& saver, Window window)
    : saver_(saver), window_(std::move(window)) {}

void SweepRecorder::start(const RecordRequest& request, PictureTexts texts) {
  const auto exchange = std::make_shared<Exchange>();
  const FrameSource source{[exchange](std::optional<double> alpha, const RunContext& context) {
    return exchange->picture_of(alpha.value(), context.cancel);
  }};
  saver_.start(recording_job(request, source, std::move(texts)));
  exchange_ = exchange;
  request_ = request;
  molecule_ = window_.molecule();
  alpha_before_ = window_.alpha();
  asked_.reset();
  viewpoint_.reset();
}

void SweepRecorder::ask(const Alpha& alpha) {
  window_.set_alpha(alpha);
  asked_ = alpha;
  quiet_frames_ = 0;
}

std::string SweepRecorder::give_up(const std::string& why) {
  exchange_ = nullptr;
  saver_.cancel();
  return why;
}

std::string SweepRecorder::step(bool quiet) {
  if (!exchange_) return {};
  const bool same_molecule = window_.molecule() == molecule_;
  const bool as_asked = window_.alpha() == asked_.value_or(alpha_before_);
  if (!saver_.busy()) {  // finished, cancelled or failed; PictureSaver tells which
    // The recorder stays busy for one more frame. The change of alpha then counts as a part of the
    // recording, and not as one by the user.
    if (asked_ && same_molecule && as_asked) {
      window_.set_alpha(alpha_before_);
      asked_.reset();
    } else {
      exchange_ = nullptr;
    }
    return {};
  }
  if (!same_molecule) {
    return give_up(
        "The recording ended because the molecule or its atoms changed. Record the sweep again.");
  }
  if (!as_asked)
    return give_up("The recording ended because alpha was changed. Record the sweep again.");
  const std::optional<Alpha> wanted = exchange_->wanted();
  if (!wanted) return {};
  if (asked_ != wanted) {
    ask(*wanted);
    return {};
  }
  quiet_frames_ = quiet ? quiet_frames_ + 1 : 0;
  if (quiet_frames_ < kQuietFrames) return {};
  if (window_.drawn_alpha() != wanted) {
    return give_up("The recording ended because one alpha has no picture. Try another range.");
  }
  return hand_over();
}

// Hands the picture over. No work is left, so a part that is missing now would never come.
std::string SweepRecorder::hand_over() {
  try {
    Picture picture = window_.take_picture({request_.path, request_.options});
    if (!viewpoint_) viewpoint_ = picture.viewpoint;
    picture.viewpoint = viewpoint_;
    exchange_->give(std::move(picture));
  } catch (const std::exception& error) {  // for example when memory is too small for the picture
    return give_up(error.what());
  }
  return {};
}

}  // namespace alphascope
