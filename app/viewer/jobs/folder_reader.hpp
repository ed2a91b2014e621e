// Reads the folder that the file dialog shows on a thread of its own, and again when the folder has
// changed. The latest question wins.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>

#include "core/run/worker.hpp"
#include "ui/panels/dialogs/folder_listing.hpp"

namespace alphascope {

class FolderReader {
 public:
  explicit FolderReader(std::function<void()> wake) : worker_(std::move(wake)) {}

  // On the main thread, before each frame. Returns the latest listing; null before the first.
  std::shared_ptr<const FolderListing> listing(const std::optional<FolderQuery>& wanted);
  // What is wanted is not there yet.
  bool busy() const { return wanted_ && (!listing_ || listing_->query != *wanted_); }

 private:
  void read(bool only_if_changed);

  std::optional<FolderQuery> wanted_;
  std::shared_ptr<const FolderListing> listing_;
  std::filesystem::file_time_type written_;  // when the folder was changed last, as listed
  std::chrono::steady_clock::time_point asked_;
  Worker worker_;  // last: joined first
};

}  // namespace alphascope
