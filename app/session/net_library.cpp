// SPDX-License-Identifier: GPL-3.0-or-later
// Loads the library that asks servers, and passes requests on to it.
#include "app/session/net_library.hpp"

#include <string>

#include "app/session/loaded_library.hpp"
#include "app/session/version.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;

constexpr LibraryKind kNet{
    .file_name = "alphascope-net.so",
    .variable = "ALPHASCOPE_NET_LIBRARY",
    .title = "network library",
    .build_symbol = "alphascope_net_build",
    .table_symbol = "alphascope_net_library",
    .if_missing =
        "Install alphascope-net.so, or install libcurl (libcurl4-openssl-dev) and build "
        "Alphascope again; or open a file that you have."};

}  // namespace

Transfer transfer_of_library(const std::vector<fs::path>& places) {
  return [places](const TransferRequest& request, const RunContext& context) {
    try {
      return reinterpret_cast<decltype(&alphascope_net_library)>(load_library(kNet, places))()->get(
          request, context);
    } catch (const UnusableLibrary& error) {
      return TransferAnswer{.end = TransferEnd::no_library, .detail = error.what()};
    }
  };
}

FetchOptions fetch_options_of_program() {
  FetchOptions options = fetch_options_of_environment();
  options.user_agent = "alphascope/" + std::string(program_version());
  options.get = transfer_of_library(library_places(kNet));
  return options;
}

}  // namespace alphascope
