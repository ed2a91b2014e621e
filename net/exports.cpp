// SPDX-License-Identifier: GPL-3.0-or-later
// The symbols of the library alphascope-net.so. It exports nothing else.
#include "core/run/library_build.hpp"
#include "net/curl_transfer.hpp"

extern "C" {

__attribute__((visibility("default"))) const char* alphascope_net_build() {
  return alphascope::library_build();
}

__attribute__((visibility("default"))) const alphascope::NetLibrary* alphascope_net_library() {
  static constexpr alphascope::NetLibrary table = {alphascope::curl_get};
  return &table;
}
}
