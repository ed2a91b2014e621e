// SPDX-License-Identifier: GPL-3.0-or-later
// Asks a server by libcurl, on the calling thread, and looks at the cancel token twenty times a
// second.
#include "net/curl_transfer.hpp"

#include <curl/curl.h>
#include <signal.h>

#include <algorithm>
#include <memory>
#include <new>
#include <string>
#include <utility>

namespace alphascope {
namespace {

constexpr int kPollMilliseconds = 50;
constexpr long kLowSpeed = 100;  // bytes per second; less counts as nothing

// A connection that the server has closed may raise SIGPIPE, which would end the program.
class WithoutSigpipe {
 public:
  WithoutSigpipe() {
    sigset_t pending;
    sigemptyset(&pipe_);
    sigaddset(&pipe_, SIGPIPE);
    sigpending(&pending);
    was_pending_ = sigismember(&pending, SIGPIPE) == 1;
    pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  ~WithoutSigpipe() {
    const timespec at_once{0, 0};
    if (!was_pending_) sigtimedwait(&pipe_, nullptr, &at_once);
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  WithoutSigpipe(const WithoutSigpipe&) = delete;
  WithoutSigpipe& operator=(const WithoutSigpipe&) = delete;

 private:
  sigset_t pipe_{}, before_{};
  bool was_pending_ = false;
};

struct Received {
  std::string bytes;
  std::uint64_t most = 0;
  bool too_large = false, no_memory = false;
};

// Called by C code, so no exception may leave it.
extern "C" std::size_t take_bytes(char* bytes, std::size_t size, std::size_t count, void* to) {
  Received& received = *static_cast<Received*>(to);
  const std::size_t all = size * count;
  received.too_large = received.bytes.size() + all > received.most;
  if (received.too_large) return 0;
  try {
    received.bytes.append(bytes, all);
  } catch (const std::bad_alloc&) {
    received.no_memory = true;
    return 0;
  }
  return all;
}

using Easy = std::unique_ptr<CURL, decltype(&curl_easy_cleanup)>;
using Multi = std::unique_ptr<CURLM, decltype(&curl_multi_cleanup)>;

template <class Value>
void set(const Easy& easy, CURLoption option, Value value) {
  if (curl_easy_setopt(easy.get(), option, value) == CURLE_OUT_OF_MEMORY) throw std::bad_alloc();
}

void set_up(const Easy& easy, const TransferRequest& request, Received& received, char* error) {
  set(easy, CURLOPT_ERRORBUFFER, error);
  set(easy, CURLOPT_URL, request.address.c_str());
  set(easy, CURLOPT_USERAGENT, request.user_agent.c_str());
  // Plain http is for a server of this computer; the caller decides (core/document/fetch).
  set(easy, CURLOPT_PROTOCOLS_STR, "http,https");
  set(easy, CURLOPT_FOLLOWLOCATION, 0L);
  set(easy, CURLOPT_SSL_VERIFYPEER, 1L);
  set(easy, CURLOPT_SSL_VERIFYHOST, 2L);
  set(easy, CURLOPT_SSLVERSION, static_cast<long>(CURL_SSLVERSION_TLSv1_2));
  set(easy, CURLOPT_NOSIGNAL, 1L);
#if LIBCURL_VERSION_NUM >= 0x075700
  set(easy, CURLOPT_QUICK_EXIT, 1L);  // a cancel does not wait for an answer about a name
#endif
  set(easy, CURLOPT_CONNECTTIMEOUT_MS, static_cast<long>(request.connect_milliseconds));
  set(easy, CURLOPT_LOW_SPEED_LIMIT, kLowSpeed);
  set(easy, CURLOPT_LOW_SPEED_TIME, static_cast<long>(request.stall_seconds));
  set(easy, CURLOPT_MAXFILESIZE_LARGE, static_cast<curl_off_t>(request.most_bytes));
  set(easy, CURLOPT_WRITEFUNCTION, take_bytes);
  set(easy, CURLOPT_WRITEDATA, static_cast<void*>(&received));
}

double share_done(const Easy& easy, const Received& received) {
  curl_off_t all = 0;
  curl_easy_getinfo(easy.get(), CURLINFO_CONTENT_LENGTH_DOWNLOAD_T, &all);
  const double done = static_cast<double>(received.bytes.size());
  return all > 0 ? std::min(1.0, done / static_cast<double>(all)) : 0;
}

TransferEnd end_of(CURLcode code, const Easy& easy) {
  switch (code) {
    case CURLE_OK:
      return TransferEnd::answered;
    case CURLE_COULDNT_RESOLVE_HOST:
    case CURLE_COULDNT_RESOLVE_PROXY:
      return TransferEnd::unknown_host;
    case CURLE_COULDNT_CONNECT:
      return TransferEnd::not_connected;
    case CURLE_OPERATION_TIMEDOUT: {
      curl_off_t connected = 0;  // microseconds
      curl_easy_getinfo(easy.get(), CURLINFO_PRETRANSFER_TIME_T, &connected);
      return connected > 0 ? TransferEnd::too_slow : TransferEnd::not_connected;
    }
    case CURLE_SSL_CONNECT_ERROR:
    case CURLE_PEER_FAILED_VERIFICATION:
    case CURLE_SSL_CACERT_BADFILE:
    case CURLE_SSL_ISSUER_ERROR:
      return TransferEnd::bad_certificate;
    case CURLE_PARTIAL_FILE:
    case CURLE_RECV_ERROR:
    case CURLE_GOT_NOTHING:
    case CURLE_HTTP2:
    case CURLE_HTTP2_STREAM:
      return TransferEnd::broken_off;
    case CURLE_FILESIZE_EXCEEDED:
      return TransferEnd::too_large;
    default:
      return TransferEnd::other;
  }
}

// Returns the code of the finished transfer; cancelled: nothing.
bool perform(const Multi& multi, const Easy& easy, const TransferRequest& request,
             const Received& received, const RunContext& context, CURLcode& code) {
  for (;;) {
    if (context.cancel.cancelled()) return false;
    int running = 0, left = 0;
    curl_multi_perform(multi.get(), &running);
    while (const CURLMsg* const message = curl_multi_info_read(multi.get(), &left)) {
      if (message->msg != CURLMSG_DONE) continue;
      code = message->data.result;
      return true;
    }
    context.report(request.stage, share_done(easy, received));
    curl_multi_poll(multi.get(), nullptr, 0, kPollMilliseconds, nullptr);
  }
}

}  // namespace

TransferAnswer curl_get(const TransferRequest& request, const RunContext& context) {
  static const CURLcode ready = curl_global_init(CURL_GLOBAL_DEFAULT);
  const WithoutSigpipe without;
  const Easy easy(ready == CURLE_OK ? curl_easy_init() : nullptr, curl_easy_cleanup);
  const Multi multi(curl_multi_init(), curl_multi_cleanup);
  if (!easy || !multi) throw std::bad_alloc();
  char error[CURL_ERROR_SIZE] = "";
  Received received{.bytes = {}, .most = request.most_bytes};
  set_up(easy, request, received, error);
  curl_multi_add_handle(multi.get(), easy.get());
  CURLcode code = CURLE_OK;
  const bool ended = perform(multi, easy, request, received, context, code);
  TransferAnswer answer;
  if (received.no_memory) {
    curl_multi_remove_handle(multi.get(), easy.get());
    throw std::bad_alloc();
  }
  answer.end = !ended               ? TransferEnd::cancelled
               : received.too_large ? TransferEnd::too_large
                                    : end_of(code, easy);
  answer.detail = error[0] != '\0' ? error : ended ? curl_easy_strerror(code) : "";
  if (answer.end == TransferEnd::answered) {
    long status = 0;
    const char* redirect = nullptr;
    curl_easy_getinfo(easy.get(), CURLINFO_RESPONSE_CODE, &status);
    curl_easy_getinfo(easy.get(), CURLINFO_REDIRECT_URL, &redirect);
    answer.status = static_cast<int>(status);
    if (redirect != nullptr) answer.redirect = redirect;
    answer.body = std::move(received.bytes);
  }
  curl_multi_remove_handle(multi.get(), easy.get());
  return answer;
}

}  // namespace alphascope
