// SPDX-License-Identifier: GPL-3.0-or-later
// Saves a table of a page in the background. Its text is a derived result. Another thread writes
// the file, which appears complete or not at all.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/viewer/jobs/file_job.hpp"
#include "core/document/export/file_writer.hpp"
#include "core/document/store/store.hpp"
#include "ui/panels/dialogs/table_state.hpp"
#include "ui/panels/dialogs/table_to_save.hpp"
#include "ui/running_job.hpp"

namespace alphascope {

class TableSaver : public ViewerJob {
 public:
  // `wake` as in Worker. `inputs` are those of the picture; they and the store must outlive this.
  TableSaver(std::function<void()> wake, Store& store, const Inputs& inputs)
      : store_(store), inputs_(inputs), file_(JobId::table, std::move(wake)) {}

  // Throws std::runtime_error (a sentence) while another table is being saved.
  void start(SaveTableRequest request);

  std::optional<RunningJob> running() const override;
  // The file stays unchanged, unless it is already written.
  void cancel() override;
  JobNews poll() override;

 private:
  using Text = std::shared_ptr<const std::string>;
  const AnyDefinition& definition() const;
  const FormatToSave* other_format() const;  // null: the file is a table
  template <class T>
  void want_as(const Definition<T>& definition, const Inputs& inputs);
  void want();
  void write(const Text& text);
  void write(const std::shared_ptr<const FileWriter>& writer);
  void write(std::function<void(const RunContext&)> how);
  void fail(const std::string& why);
  std::string title() const { return "Saving " + wanted_->path.filename().string(); }

  Store& store_;
  const Inputs& inputs_;
  std::optional<SaveTableRequest> wanted_;  // its text is being made; none: no text is wanted
  bool begun_ = false;
  std::chrono::steady_clock::time_point since_;
  JobNews news_;
  FileJob file_;  // writes the text when it is there
};

}  // namespace alphascope
