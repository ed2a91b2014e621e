// Reads and writes session files on threads of their own, and finds the molecules that they name.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/document/session/session_file.hpp"
#include "core/run/worker.hpp"

namespace alphascope {

// A session that was read, and what its files are by now.
struct FoundSession {
  std::filesystem::path file;  // the session itself; absolute. Empty: it is in no file
  bool is_recent = true;       // its molecule, or itself, is to be listed among the recent files
  ReadSession read;
  FoundFile molecule;
  std::optional<FoundFile> radii_table;  // none: it needs none

  bool complete() const;        // every file is the one that was saved with
  bool can_open() const;        // every file is there
  std::string problem() const;  // what is to be told when it is not complete
};

class SessionFiles {
 public:
  explicit SessionFiles(std::function<void()> wake) : reader_(wake), writer_(std::move(wake)) {}

  void open(const std::filesystem::path& file);
  // The session that take() gave last, with another molecule.
  void open_with(std::shared_ptr<const FoundSession> session,
                 const std::filesystem::path& molecule);
  void cancel() { reader_.cancel(); }
  // Its molecule's hash is set; that of a table of radii is found here.
  void save(const SessionDocument& session, const std::filesystem::path& file);

  Worker::Activity reading() const { return reader_.activity(); }
  bool busy() const { return reader_.activity().busy || writer_.activity().busy; }

  struct Outcome {
    std::shared_ptr<const FoundSession> read;
    std::optional<std::filesystem::path> saved;
    std::string error_title, error;
  };
  Outcome poll();  // on the main thread; what came since the last call

 private:
  Outcome outcome_;
  Worker reader_, writer_;  // last: joined first
};

}  // namespace alphascope
