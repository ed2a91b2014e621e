// SPDX-License-Identifier: GPL-3.0-or-later
// Starts tests/support/fetch_server.py, which stands for the PDB and AlphaFold DB.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string>

namespace alphascope::testing {

class FetchServer {
 public:
  FetchServer() {
    int in[2] = {}, out[2] = {};
    if (::pipe(in) != 0 || ::pipe(out) != 0) return;
    process_ = ::fork();
    if (process_ == 0) {
      ::dup2(in[0], 0);
      ::dup2(out[1], 1);
      for (const int end : {in[0], in[1], out[0], out[1]}) ::close(end);
      const std::string script =
          std::string(ALPHASCOPE_SOURCE_DIR) + "/tests/support/fetch_server.py";
      ::execlp("python3", "python3", script.c_str(), nullptr);
      ::_exit(127);
    }
    ::close(in[0]);
    ::close(out[1]);
    input_ = in[1];
    std::FILE* const ports = ::fdopen(out[0], "r");
    EXPECT_EQ(std::fscanf(ports, "%d %d", &port_, &tls_port_), 2);
    std::fclose(ports);
  }
  ~FetchServer() {
    ::close(input_);  // which ends it
    ::waitpid(process_, nullptr, 0);
  }
  FetchServer(const FetchServer&) = delete;
  FetchServer& operator=(const FetchServer&) = delete;

  std::string address() const { return "http://127.0.0.1:" + std::to_string(port_); }
  // With a certificate that nobody signed; empty if there is no openssl to make one.
  std::string tls_address() const {
    return tls_port_ == 0 ? "" : "https://127.0.0.1:" + std::to_string(tls_port_);
  }

 private:
  pid_t process_ = -1;
  int input_ = -1, port_ = 0, tls_port_ = 0;
};

// Proxies and addresses of the surrounding system must not change the tests.
inline void forget_network_variables() {
  for (const char* name : {"http_proxy", "https_proxy", "HTTPS_PROXY", "all_proxy", "ALL_PROXY",
                           "no_proxy", "NO_PROXY", "ALPHASCOPE_OFFLINE", "ALPHASCOPE_FETCH_BASE",
                           "ALPHASCOPE_NET_LIBRARY", "XDG_CACHE_HOME"}) {
    ::unsetenv(name);
  }
}

}  // namespace alphascope::testing
