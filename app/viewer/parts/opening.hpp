// Opening molecules and sessions. A session that was read waits here until its molecule is open, so
// that whatever goes wrong on the way leaves the window as it is.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/session/session.hpp"
#include "app/viewer/jobs/session_files.hpp"
#include "app/viewer/parts/due_frames.hpp"
#include "app/viewer/parts/history.hpp"
#include "app/viewer/parts/window_preferences.hpp"
#include "app/viewer/scene/scene_controller.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/window/host.hpp"

namespace alphascope {

class Opening {
 public:
  // `benchmark_busy`: a benchmark runs, which is of the open molecule.
  Opening(Host& host, ViewState& state, SceneController& scene, Session& session, History& history,
          WindowPreferences& preferences, DueFrames& due, std::function<bool()> benchmark_busy)
      : state_(state),
        scene_(scene),
        session_(session),
        history_(history),
        preferences_(preferences),
        due_(due),
        benchmark_busy_(std::move(benchmark_busy)),
        files_([&host] { host.wake(); }) {}

  void open(const std::filesystem::path& path);  // a molecule, or a session by its name
  void open_session(const std::filesystem::path& path);
  // One of them; what becomes of the others is told.
  void open_dropped(const std::vector<std::filesystem::path>& files);
  // The session that waits for an answer: with this molecule; empty: with the files as they are.
  void go_on(const std::filesystem::path& molecule);
  void forget_waiting_session();
  void start(FoundSession session);  // as if it had been read from a file
  void save(const std::filesystem::path& file);
  void poll();  // takes in what was read and saved

  // The session whose molecule is on its way; null: none.
  const std::shared_ptr<const FoundSession>& starting() const { return starting_; }
  // Its molecule is there: its settings and its window take the place of those of a molecule that
  // is opened by itself.
  void show_session();
  void forget_failed();          // the file cannot be opened
  std::string take_drop_note();  // of the file that has been read
  std::string not_opened_either();

  Request possible_here(Request request) const;
  // None without a molecule.
  std::optional<SessionDocument> document(const std::filesystem::path& file) const;
  SessionView window_of_session() const;  // without the camera
  Worker::Activity reading() const { return files_.reading(); }
  bool busy() const { return files_.busy() || waiting_ || starting_; }

 private:
  bool may_open(const std::filesystem::path& path);  // tells why not; forgets notes of the last
  void start_session();                              // waiting_

  ViewState& state_;
  SceneController& scene_;
  Session& session_;
  History& history_;
  WindowPreferences& preferences_;
  DueFrames& due_;
  std::function<bool()> benchmark_busy_;
  SessionFiles files_;
  // Read, and not decided upon; then with its molecule on its way. Null: none.
  std::shared_ptr<const FoundSession> waiting_, starting_;
  bool awaits_gpu_ = false;
  std::string drop_note_;  // of the file that is being read
};

}  // namespace alphascope
