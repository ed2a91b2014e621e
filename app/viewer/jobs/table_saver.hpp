// Saves a table of a page in the background. Its text is a derived result. Another thread writes
// the file, which appears complete or not at all.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/document/store/store.hpp"
#include "core/run/worker.hpp"
#include "ui/panels/dialogs/table_memory.hpp"
#include "ui/panels/view_info.hpp"

namespace alphascope {

class TableSaver {
 public:
  explicit TableSaver(std::function<void()> wake);  // as in Worker

  // Throws std::runtime_error while another table is being saved.
  void start(SaveTableRequest request);
  // The file stays unchanged, unless it is already written.
  void cancel(Store& store);
  bool busy() const { return saving_.has_value(); }

  struct Outcome {
    std::string notice;  // the table was saved, or its job was cancelled
    std::string error;   // why the table could not be saved
    bool any() const { return !notice.empty() || !error.empty(); }
  };
  // Call in each frame on the main thread. `inputs` are those of the picture.
  Outcome poll(Store& store, const Inputs& inputs);
  // Fills `info` for the line of progress while a table is being saved.
  void describe(BusyInfo& info) const;

 private:
  using Text = std::shared_ptr<const std::string>;
  const AnyDefinition& definition() const;
  const FormatToSave* other_format() const;  // null: the file is a table
  template <class T>
  void want_as(const Definition<T>& definition, Store& store, const Inputs& inputs);
  void want(Store& store, const Inputs& inputs);
  void write(const Text& text);
  void write(const std::shared_ptr<const FileWriter>& writer);
  void submit(std::function<void(const RunContext&)> write);
  void fail(const std::string& why);

  std::optional<SaveTableRequest> saving_;
  bool begun_ = false, writing_ = false;
  std::chrono::steady_clock::time_point since_;
  Outcome outcome_;
  Worker worker_;  // last member, so that its thread is joined first
};

}  // namespace alphascope
