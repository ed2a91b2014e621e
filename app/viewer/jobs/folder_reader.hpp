// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the folder of the file dialog on a thread of its own, and again when the folder has
// changed. The latest query wins.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>

#include "app/viewer/jobs/job_list.hpp"
#include "core/run/worker.hpp"
#include "ui/panels/dialogs/folder_listing.hpp"

namespace alphascope {

class FolderReader : public ViewerJob {
 public:
  explicit FolderReader(std::function<void()> wake) : worker_(std::move(wake)) {}

  // Call on the main thread before each frame. Returns the latest listing; null before the first.
  std::shared_ptr<const FolderListing> listing(const std::optional<FolderQuery>& wanted);
  // True while the listing of the wanted folder is not ready.
  bool busy() const { return wanted_ && (!listing_ || listing_->query != *wanted_); }

  std::optional<RunningJob> running() const override;
  void cancel() override { worker_.cancel(); }
  JobNews poll() override { return {}; }  // listing() takes in what was read

 private:
  void read(bool only_if_changed);

  std::optional<FolderQuery> wanted_;
  std::shared_ptr<const FolderListing> listing_;
  std::filesystem::file_time_type written_;  // time of the folder's last change, as listed
  std::chrono::steady_clock::time_point asked_;
  Worker worker_;  // last member, so that its thread is joined first
};

}  // namespace alphascope
