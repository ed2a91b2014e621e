// SPDX-License-Identifier: GPL-3.0-or-later
// The molecule that is read ahead, and who takes it over.
#include "app/viewer/read_ahead.hpp"

#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <system_error>
#include <utility>

namespace alphascope {
namespace {

constexpr std::uintmax_t kMostBytes = std::uintmax_t{4} << 20;

struct Ahead {
  std::filesystem::path path;
  RunContext context;
  std::atomic<bool> taken = false;
  std::future<OpenedMolecule> molecule;
  ~Ahead() { context.cancel.cancel(); }  // before the future waits for its thread
};

}  // namespace

Session::Opener read_ahead(const std::filesystem::path& path, Session::Opener open) {
  std::error_code fault;
  const std::uintmax_t bytes = std::filesystem::file_size(path, fault);
  if (fault || bytes > kMostBytes) return open;
  const auto ahead = std::make_shared<Ahead>();
  ahead->path = path;
  try {
    ahead->molecule = std::async(std::launch::async, [path, open, context = ahead->context] {
      return open(path, OpenOptions(), context);
    });
  } catch (const std::system_error&) {  // there is no thread
    return open;
  }
  return [ahead, open = std::move(open)](const std::filesystem::path& wanted,
                                         const OpenOptions& options, const RunContext& context) {
    const bool fits = wanted == ahead->path && options == OpenOptions();
    if (!fits || ahead->taken.exchange(true)) return open(wanted, options, context);
    constexpr std::chrono::milliseconds kBetweenChecks{5};
    while (ahead->molecule.wait_for(kBetweenChecks) != std::future_status::ready) {
      if (context.cancel.cancelled()) ahead->context.cancel.cancel();
    }
    return ahead->molecule.get();
  };
}

}  // namespace alphascope
