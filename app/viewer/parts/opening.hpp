// SPDX-License-Identifier: GPL-3.0-or-later
// Opens molecules and sessions. A session that was read waits here until its molecule is open, so a
// failure leaves the window unchanged.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/session/session.hpp"
#include "app/viewer/frames/due_frames.hpp"
#include "app/viewer/jobs/fetcher.hpp"
#include "app/viewer/parts/history.hpp"
#include "app/viewer/parts/window_preferences.hpp"
#include "app/viewer/saving/session_files.hpp"
#include "app/viewer/scene/scene_controller.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/window/host.hpp"

namespace alphascope {

class Opening {
 public:
  // `benchmark_busy`: whether a benchmark runs. It measures the open molecule, which must stay
  // open.
  Opening(Host& host, ViewState& state, SceneController& scene, Session& session, History& history,
          WindowPreferences& preferences, DueFrames& due, std::function<bool()> benchmark_busy)
      : state_(state),
        scene_(scene),
        session_(session),
        history_(history),
        preferences_(preferences),
        due_(due),
        benchmark_busy_(std::move(benchmark_busy)),
        files_([&host] { host.wake(); }),
        fetcher_([&host] { host.wake(); }) {}

  void open(const std::filesystem::path& path);  // a molecule or, by the name's ending, a session
  void open_session(const std::filesystem::path& path);
  void fetch(const MoleculeId& id, bool again);  // then opens the file
  void fetch_for_session();                      // the molecule of the waiting session
  // Opens one of the files and notes why the others are not opened.
  void open_dropped(const std::vector<std::filesystem::path>& files);
  // Opens the waiting session with this molecule. An empty path means its own files as they are
  // now.
  void go_on(const std::filesystem::path& molecule);
  void forget_waiting_session();
  void start(FoundSession session);  // treats the session as if it had been read from a file
  void save(const std::filesystem::path& file);
  void poll();  // takes in finished reads and saves

  // The session whose molecule is being opened; null: none.
  const std::shared_ptr<const FoundSession>& starting() const { return starting_; }
  // Call when its molecule is open. Applies the session's settings and window in place of a
  // molecule's defaults.
  void show_session();
  void forget_failed();          // the file cannot be opened: drops its session, if any
  std::string take_drop_note();  // the note about other dropped files, once
  std::string not_opened_either();

  Request possible_here(Request request) const;
  // Nothing if no molecule is open.
  std::optional<SessionDocument> document(const std::filesystem::path& file) const;
  SessionView window_of_session() const;  // all but the camera
  Worker::Activity reading() const { return files_.reading(); }
  ViewerJob& writer() { return files_.writer(); }  // the job that writes a session
  ViewerJob& fetcher() { return fetcher_; }
  // A session is read or written, or a molecule is fetched.
  bool busy() const { return files_.busy() || fetcher_.busy(); }
  bool opens_session() const { return files_.reading().busy || waiting_ || starting_; }

 private:
  // Returns whether a file may be opened; if not, shows why. Clears notes about the last file.
  bool may_open(const std::filesystem::path& path);
  std::string fetchable_id() const;
  void start_session();  // starts waiting_

  ViewState& state_;
  SceneController& scene_;
  Session& session_;
  History& history_;
  WindowPreferences& preferences_;
  DueFrames& due_;
  std::function<bool()> benchmark_busy_;
  SessionFiles files_;
  // A session in waiting_ waits for the user's decision or for the search for a GPU. In starting_
  // its molecule is being opened. Null: none.
  std::shared_ptr<const FoundSession> waiting_, starting_;
  bool awaits_gpu_ = false;
  std::string drop_note_;  // of the file that is being read
  Fetcher fetcher_;        // last, so that its thread is joined first
};

}  // namespace alphascope
