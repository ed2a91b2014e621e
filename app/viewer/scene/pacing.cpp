// SPDX-License-Identifier: GPL-3.0-or-later
// Chooses the quality of each picture, and draws it.
#include "app/viewer/scene/pacing.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "core/run/picture_stages.hpp"

namespace alphascope {
namespace {

constexpr double kRefineAfterSeconds = 0.25;
// An outdated picture is not refined for this many seconds, if samples are slow. Its replacement
// would have to wait for them.
constexpr double kReplacedWithinSeconds = 2;
// Length of a slice of refinement, if one sample takes less.
constexpr double kSliceMilliseconds = 12;
constexpr std::chrono::milliseconds kOutdatedAfter{300};

}  // namespace

void Pacing::begin_picture(double mesh_milliseconds) {
  outdated_since_.reset();
  new_picture_ = true;
  stages_ = {{std::string(stage::kMesh), mesh_milliseconds, false}};
}

void Pacing::forget_times() {
  quality_.forget();
  balls_.forget();
}

bool Pacing::note_age(bool outdated) {
  if (!outdated) outdated_since_.reset();
  if (outdated && !outdated_since_) outdated_since_ = Clock::now();
  return outdated_since_ && Clock::now() - *outdated_since_ >= kOutdatedAfter;
}

double Pacing::seconds_to_refinement() const {
  if (!refine_) return kNotDue;
  const auto left = [](double seconds, Clock::time_point since) {
    return std::max(0.0, seconds - std::chrono::duration<double>(Clock::now() - since).count());
  };
  double due = drawn_ == RenderQuality::fine ? 0 : left(kRefineAfterSeconds, last_change_);
  if (outdated_since_ && quality_.sample() > kSliceMilliseconds) {
    due = std::max(due, left(kReplacedWithinSeconds, *outdated_since_));
  }
  return due;
}

bool Pacing::draw_when_due(bool interacting, bool pending, bool patient) {
  const bool change = canvas_.take_change();
  if (change) last_change_ = Clock::now();
  const bool refine_now = refine_ && !interacting && seconds_to_refinement() <= 0;
  const bool draws = change || refine_now || (patient && unfinished());
  take_time(draws);
  if (!draws) return false;
  const bool new_picture = std::exchange(new_picture_, false);
  if (new_picture) drawing_since_ = Clock::now();
  const bool follows = interacting && (pending || new_picture);
  const bool at_rest = refine_now && !change;
  const RenderQuality target = patient   ? RenderQuality::fine
                               : at_rest ? quality_.at_rest()
                                         : quality_for_change(follows);
  choose_stand_in(at_rest || patient);
  draw(target, patient);
  drawn_ = target;
  refine_ = (quality_.at_rest() == RenderQuality::fine && unfinished()) ||
            target == RenderQuality::sketch || canvas_.without_balls();
  return true;
}

// Returns the quality after a change. Exact translucency is left to pictures at rest, since each
// layer takes a pass.
RenderQuality Pacing::quality_for_change(bool follows_computation) const {
  const RenderQuality best = follows_computation ? quality_.while_computing() : quality_.moving();
  return canvas_.scene().draws_translucent() ? std::min(best, RenderQuality::draft) : best;
}

void Pacing::choose_stand_in(bool at_rest) {
  const bool faces = picture_.parts.mesh && picture_.parts.mesh->faces_drawn() > 0;
  canvas_.leave_out_balls(canvas_.style().balls && balls_.wanted(at_rest, faces));
}

// Draws as many samples of a fine picture as fit into a slice: at least one.
void Pacing::draw(RenderQuality quality, bool patient) {
  Scene& scene = canvas_.drawing();
  const int width = canvas_.width(), height = canvas_.height();
  if (quality != RenderQuality::fine && !patient) {
    drawn_ = quality;
    scene.start_render(width, height, quality);
    return take_time(false);
  }
  double taken = 0;
  do {
    const double milliseconds = scene.render(width, height, quality);
    note_times(quality, milliseconds);
    taken += milliseconds;
    drawn_ = quality;
  } while (quality == RenderQuality::fine && unfinished() &&
           (patient || taken + quality_.sample() <= kSliceMilliseconds));
}

// The graphics processor's own time is added, because the program reads it a frame later.
std::optional<Pacing::Clock::time_point> Pacing::finished() const {
  if (stages_.size() < 2) return std::nullopt;
  double milliseconds = 0;
  for (std::size_t i = 1; i < stages_.size(); ++i) milliseconds += stages_[i].milliseconds;
  return drawing_since_ + std::chrono::duration_cast<Clock::duration>(
                              std::chrono::duration<double, std::milli>(milliseconds));
}

bool Pacing::unfinished() const {
  return drawn_ != RenderQuality::fine || canvas_.scene().samples_drawn() < canvas_.style().samples;
}

void Pacing::take_time(bool wait) {
  if (const auto taken = canvas_.drawing().take_milliseconds(wait)) note_times(drawn_, *taken);
}

// The upload of balls and edges counts as part of the drawing.
void Pacing::note_times(RenderQuality quality, double picture_milliseconds) {
  if (!canvas_.without_balls()) {
    quality_.note(quality, picture_milliseconds);
    if (canvas_.style().balls) balls_.note(quality, picture_milliseconds);
  }
  const double upload = canvas_.drawing().take_upload_milliseconds();
  if (stages_.size() != 1) return;
  stages_.push_back({std::string(stage::kUpload), upload, false});
  stages_.push_back({std::string(stage::kDraw), picture_milliseconds - upload, false});
}

}  // namespace alphascope
