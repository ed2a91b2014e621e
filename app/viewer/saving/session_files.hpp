// SPDX-License-Identifier: GPL-3.0-or-later
// Reads and writes session files on threads of their own, and finds the molecules that sessions
// name.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/viewer/jobs/file_job.hpp"
#include "core/document/session/session_file.hpp"
#include "core/run/worker.hpp"
#include "ui/panels/error_kind.hpp"
#include "ui/running_job.hpp"

namespace alphascope {

// A session that was read, and the present state of its files.
struct FoundSession {
  std::filesystem::path file;  // absolute path of the session; empty: no file
  bool is_recent = true;       // opening adds the molecule or the session to the recent files
  ReadSession read;
  FoundFile molecule;
  std::optional<FoundFile> radii_table;  // none: the session needs no table

  bool complete() const;        // all files are as they were when the session was saved
  bool can_open() const;        // all files exist
  std::string problem() const;  // a message if complete() is false
};

class SessionFiles {
 public:
  explicit SessionFiles(std::function<void()> wake)
      : reader_(wake), writer_(JobId::session, std::move(wake)) {}

  void open(const std::filesystem::path& file);
  // Opens `session` with another molecule.
  void open_with(std::shared_ptr<const FoundSession> session,
                 const std::filesystem::path& molecule);
  void cancel() { reader_.cancel(); }
  // The hash of the molecule must be set. The hash of a table of radii is computed here.
  // `when_saved` runs on the main thread. Throws std::runtime_error (a sentence) while another
  // session is being written.
  void save(const SessionDocument& session, const std::filesystem::path& file,
            std::function<void()> when_saved);
  ViewerJob& writer() { return writer_; }

  Worker::Activity reading() const { return reader_.activity(); }
  bool busy() const { return reader_.activity().busy || writer_.busy(); }

  struct Outcome {
    std::shared_ptr<const FoundSession> read;
    std::string error_title, error;
    ErrorKind error_kind = ErrorKind::input;
  };
  Outcome poll();  // what was read since the last call; on the main thread

 private:
  Outcome outcome_;
  Worker reader_;  // last but one, so that its thread is joined before what it uses goes
  FileJob writer_;
};

}  // namespace alphascope
