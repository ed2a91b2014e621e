// SPDX-License-Identifier: GPL-3.0-or-later
// Decides when to read a folder again.
#include "app/viewer/jobs/folder_reader.hpp"

#include <utility>

#include "core/geometry/alpha.hpp"
#include "core/text/printable.hpp"
#include "ui/running_job.hpp"

namespace alphascope {
namespace {

// Interval at which a shown folder is checked for changes.
constexpr std::chrono::seconds kLookAgainAfter{1};

}  // namespace

std::shared_ptr<const FolderListing> FolderReader::listing(
    const std::optional<FolderQuery>& wanted) {
  worker_.poll();
  const bool another = wanted && wanted != wanted_;
  wanted_ = wanted;
  if (!wanted) {
    if (worker_.activity().busy) worker_.cancel();
    return listing_;
  }
  const bool old = std::chrono::steady_clock::now() - asked_ >= kLookAgainAfter;
  if (another) {
    read(false);
  } else if (old && !worker_.activity().busy) {
    read(!busy());
  }
  return listing_;
}

std::optional<RunningJob> FolderReader::running() const {
  if (!busy() || !worker_.activity().busy) return std::nullopt;
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - asked_;
  return RunningJob{
      JobId::listing, "Reading " + printable(wanted_->folder.string()), {}, -1, seconds.count()};
}

void FolderReader::read(bool only_if_changed) {
  asked_ = std::chrono::steady_clock::now();
  worker_.submit([this, query = *wanted_, only_if_changed,
                  known = written_](const RunContext& context) -> Worker::Delivery {
    std::error_code ignored;
    const auto written = std::filesystem::last_write_time(query.folder, ignored);
    if (only_if_changed && written == known) return {};
    auto listing = std::make_shared<const FolderListing>(list_folder(query, context.cancel));
    return [this, listing = std::move(listing), written] {
      listing_ = listing;
      written_ = written;
    };
  });
}

}  // namespace alphascope
