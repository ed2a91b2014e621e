// SPDX-License-Identifier: GPL-3.0-or-later
// Updates texts about work: the badge of CGAL's comparison, the line on background work, and the
// picture's stages.
#include "app/viewer/parts/work_status.hpp"

#include <cmath>
#include <string>

#include "app/viewer/session_text.hpp"
#include "core/document/store/derived.hpp"
#include "core/text/printable.hpp"
#include "ui/panels/playback.hpp"
#include "ui/panels/window_settings.hpp"
#include "ui/panels/work_info.hpp"
#include "ui/running_job.hpp"

namespace alphascope {
namespace {

// "Filtration of all simplices 45 %", or why the filtration is not made.
BackgroundInfo background_text(const std::vector<JobInfo>& jobs) {
  BackgroundInfo info;
  bool of_all_simplices = false;
  for (const JobInfo& job : jobs) {
    // Panels show the progress of results that follow the slider. This line names such results only
    // if they cannot be made.
    const bool running = job.state == DerivedState::running && job.lane == Lane::background;
    const bool failed = job.state == DerivedState::failed || job.state == DerivedState::no_room;
    if (running) {
      info.text = job.title;
      if (job.share > 0) info.text += " " + std::to_string(std::lround(job.share * 100)) + " %";
    } else if (failed && info.text.empty()) {
      info.text = "without: " + job.title;
    }
    if (!running && !failed) continue;
    of_all_simplices |= job.id == whole_triangulation().id || job.id == whole_filtration().id;
    if (!info.detail.empty()) info.detail += "\n";
    info.detail +=
        job.title + ": " +
        (running ? "is made in the background" + (job.stage.empty() ? "" : ", " + job.stage) + "."
                 : "is not made. " + job.why);
  }
  if (of_all_simplices) {
    info.detail += "\nAfter that, the CPU finds the complex of any alpha in it, without computing.";
  }
  return info;
}

}  // namespace

WorkStatus::WorkStatus(ViewState& state, Session& session, const SceneController& scene,
                       const Store& store, Opening& opening, JobList& jobs)
    : state_(state),
      session_(session),
      scene_(scene),
      store_(store),
      files_(opening),
      opening_(JobId::opening, {[this] { return session_.activity().opening; },
                                [this] {
                                  const auto path = session_.activity().opening_path;
                                  return path.empty()
                                             ? state_.molecule.name
                                             : "Opening " + printable(path.filename().string());
                                },
                                [this] { cancel(); }}),
      computing_(JobId::computing, {[this] { return session_.activity().computing; },
                                    [] { return std::string("Computing"); }, [this] { cancel(); }}),
      comparing_(JobId::comparing, {[this] { return session_.activity().comparing; },
                                    [] { return std::string("Comparing with CGAL"); },
                                    [this] { session_.cancel_comparison(); }}),
      timing_(JobId::comparing, {[this] { return session_.activity().timing; },
                                 [] { return std::string("Timing CGAL with all threads"); },
                                 [this] { session_.cancel_comparison(); }}),
      reading_(JobId::opening,
               {[this] { return files_.reading(); },
                [] { return std::string("Opening the session"); }, [this] { cancel(); }}) {
  for (ActivityJob* const job : {&opening_, &computing_, &comparing_, &timing_, &reading_})
    jobs.add(*job);
}

void WorkStatus::cancel() {
  state_.playback.alpha = state_.playback.models = false;
  session_.cancel_opening();
  files_.forget_waiting_session();
  if (session_.activity().computing.busy) {
    cancelled_ = session_.state().request;
    state_.notice.clear();  // it may be about the change whose result will not come
  }
  session_.cancel_computing();
  session_.cancel_comparison();
}

void WorkStatus::compare() {
  compared_ = session_.state().ours;
  session_.request_comparison();
}

void WorkStatus::update_badge() {
  state_.badge =
      describe_agreement(session_.state(), state_.result.get(), session_.activity().comparing.busy);
  const SessionState& s = session_.state();
  if (state_.badge.state == BadgeInfo::State::not_compared &&
      s.error_source == SessionState::Source::comparing) {
    state_.badge = {BadgeInfo::State::failed, s.last_error};
  }
  if (const auto comparing = comparing_.running()) state_.badge.seconds = comparing->seconds;
  if (state_.badge.state == BadgeInfo::State::not_compared && compares_by_itself() &&
      compared_ != session_.state().ours) {
    state_.badge = {BadgeInfo::State::comparing, "waiting for the comparison with CGAL…"};
  }
}

void WorkStatus::update_cancelled() {
  const SessionState& s = session_.state();
  const SessionActivity a = session_.activity();
  state_.computing_cancelled.clear();
  if (!s.opened || s.up_to_date() || cancelled_ != s.request) cancelled_.reset();
  if (!cancelled_ || a.computing.unfinished() || a.opening.unfinished()) return;
  const Request* const shown = state_.shown_request();
  state_.computing_cancelled =
      shown == nullptr ? "Computing was cancelled." : cancelled_text(*shown);
}

void WorkStatus::update_background() {
  const std::vector<JobInfo> derived = store_.jobs();
  state_.background = background_text(derived);
  for (const JobInfo& job : derived) {
    const bool waits = job.state == DerivedState::waiting;
    if (!waits && job.state != DerivedState::running) continue;
    state_.jobs.push_back({.id = JobId::deriving,
                           .title = job.title,
                           .step = job.stage,
                           .share = job.share > 0 ? job.share : -1,
                           .waits = waits,
                           .result = job.id});
  }
  time_left_.follow(state_.jobs);
}

bool WorkStatus::compares_by_itself() const {
  const auto& ours = session_.state().ours;
  return state_.window.auto_compare && ours && ours->request.engine != EngineChoice::cgal &&
         state_.molecule.balls <= kMostBallsToCompareUnasked;
}

void WorkStatus::compare_when_due(bool interacting) {
  const auto& s = session_.state();
  if (!compares_by_itself() || !s.up_to_date() || compared_ == s.ours || interacting) return;
  compared_ = s.ours;
  session_.request_comparison();
}

// Appends the picture's stages to the engine's, in the run that made the complex.
void WorkStatus::add_picture_stages() {
  const auto& answer = scene_.drawn().answer;
  if (!answer || answer != session_.state().ours) return;
  auto& run = answer->cold ? state_.ours.cold : state_.ours.warm;
  if (!run || run->alpha_angstrom2 != answer->request.alpha_angstrom2) return;
  const auto& stages = scene_.shown().pacing().stages();
  if (stages.size() > 1) {
    run->times.stages.insert(run->times.stages.end(), stages.begin(), stages.end());
  }
}

}  // namespace alphascope
