// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary between the programs and the library that asks servers, alphascope-net.so. It is
// loaded when a program first fetches a file (app/session/net_library.hpp), so programs start
// without libcurl.
//
// As with the GPU engines (core/engines/gpu_library.hpp), both sides must be of the same build. No
// exceptions cross this boundary, except for short memory.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "core/run/cancel_token.hpp"

namespace alphascope {

// One GET request. Certificates are checked, and variables for proxies are honoured.
struct TransferRequest {
  std::string address;
  std::string user_agent;
  std::string stage;  // label of the progress
  std::uint64_t most_bytes = 0;
  int connect_milliseconds = 0;
  int stall_seconds = 0;  // limit of the time in which nearly nothing arrives
};

enum class TransferEnd {
  answered,
  cancelled,
  no_library,       // detail is a sentence with the remedy
  unknown_host,     // the name has no address
  not_connected,    // nobody accepted the connection in time
  bad_certificate,  // or no agreement on encryption
  too_slow,
  broken_off,  // fewer bytes than announced
  too_large,
  other
};

struct TransferAnswer {
  TransferEnd end = TransferEnd::other;
  std::string detail = {};    // of the fault; no sentence
  int status = 0;             // of HTTP, if answered
  std::string body = {};      // if answered
  std::string redirect = {};  // the address that the server names instead; empty: none
};

// Follows no redirect. Ends within 0.1 s after a cancel.
using Transfer = std::function<TransferAnswer(const TransferRequest&, const RunContext&)>;

struct NetLibrary {
  TransferAnswer (*get)(const TransferRequest& request, const RunContext& context);
};

}  // namespace alphascope

// The symbols that the library exports, as those of the GPU library.
extern "C" {
const char* alphascope_net_build();
const alphascope::NetLibrary* alphascope_net_library();
}
