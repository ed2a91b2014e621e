// SPDX-License-Identifier: GPL-3.0-or-later
// Makes addresses of ids, asks the servers, and checks each answer before it is kept.
#include "core/document/fetch/fetch.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/files/atomic_file.hpp"
#include "core/files/read_error.hpp"
#include "core/files/read_options.hpp"
#include "core/text_files/gzip.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPdbServer = "https://files.rcsb.org";
constexpr const char *kPdbFolder = "/download/", *kPdbEnding = ".cif.gz";
constexpr const char* kAlphaFoldServer = "https://alphafold.ebi.ac.uk";
// The largest entries of the PDB have some 100 MB, packed.
constexpr std::uint64_t kLargestFile = std::uint64_t{512} << 20, kLargestAnswer = 4 << 20;  // bytes
constexpr int kMostRedirects = 5;
constexpr const char* kTryLater = "Try again later, or open a file that you have";
constexpr const char* kCheckConnection =
    "Check the connection and the variables for proxies, or open a file that you have";

// The scheme and the host of an address, with the port.
std::string server_of(const std::string& address) {
  return address.substr(0, address.find('/', address.find("://") + 3));
}

std::string host_of(const std::string& address) {
  const std::string server = server_of(address);
  return server.substr(server.find("://") + 3);
}

// Whether the text begins like mmCIF: a data block, perhaps after comments. Pages of errors and of
// logins do not.
bool looks_like_mmcif(std::string_view text) {
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    if (line.starts_with("data_")) return true;
    if (line.find_first_not_of(" \t\r") != std::string_view::npos && !line.starts_with('#')) {
      return false;
    }
    text.remove_prefix(std::min(text.size(), line.size() + 1));
  }
  return false;
}

class Fetching {
 public:
  Fetching(const MoleculeId& id, const FetchOptions& options, const RunContext& context)
      : id_(id), options_(options), context_(context) {}

  // Throws std::invalid_argument that says why an answer is not the wanted file.
  using Check = std::function<void(const std::string& body)>;

  // The file of this address, fetched now or before.
  fs::path file(const std::string& address, std::uint64_t most_bytes, const Check& check) {
    if (options_.folder.empty()) {
      fail(
          "there is no folder for fetched files, because neither XDG_CACHE_HOME nor HOME names one",
          "Set one of them to a folder");
    }
    const fs::path path = fetched_file_path(options_.folder, address);
    std::error_code ignored;
    if (!options_.again && fs::exists(path, ignored)) return path;
    if (options_.offline) {
      fail(
          "it was not fetched before, and nothing is fetched now (--offline or ALPHASCOPE_OFFLINE)",
          "Fetch it without that, or open a file that you have");
    }
    keep([&] {  // before the transfer, which may take long
      make_output_folder(path.parent_path());
    });
    const std::string body = get(address, most_bytes);
    try {
      check(body);
    } catch (const std::invalid_argument& error) {
      fail(host_of(address) + " sent " + error.what(), kTryLater);
    }
    keep([&] {
      // No output replaces a file that was read. The old file is removed instead: whoever reads it
      // keeps it.
      if (options_.again) fs::remove(path, ignored);
      AtomicFile file(path);
      file.write(body);
      file.commit();
    });
    return path;
  }

  [[noreturn]] void fail(const std::string& reason, const std::string& remedy) const {
    throw ReadError(id_.typed, 0,
                    id_.without_name ? "there is no such file, and " + id_.text() +
                                           " cannot be fetched: " + reason
                                     : reason,
                    remedy);
  }

 private:
  template <class Action>
  void keep(const Action& action) const {
    try {
      action();
    } catch (const WriteError& error) {
      throw WriteError(id_.typed + ": the fetched file cannot be kept. " + error.what() +
                       " XDG_CACHE_HOME can name another folder than " +
                       options_.folder.parent_path().string() + ".");
    }
  }

  std::string get(std::string address, std::uint64_t most_bytes) const {
    for (int redirects = 0;; ++redirects) {
      TransferAnswer answer =
          options_.get({address, options_.user_agent, "fetching " + id_.text(), most_bytes,
                        options_.connect_milliseconds, options_.stall_seconds},
                       context_);
      if (answer.end == TransferEnd::cancelled) throw Cancelled();
      if (answer.end != TransferEnd::answered) fail_to_transfer(address, answer);
      if (answer.redirect.empty()) {
        if (answer.status != 200) fail_by_status(address, answer.status);
        return std::move(answer.body);
      }
      address = redirected(address, answer.redirect, redirects);
    }
  }

  std::string redirected(const std::string& from, const std::string& to, int redirects) const {
    if (redirects == kMostRedirects) {
      fail(host_of(from) + " redirects again and again", kTryLater);
    }
    const bool loopback = !options_.base.empty() && is_loopback(to);
    if (!to.starts_with("https://") && !loopback) {
      fail(host_of(from) + " redirects to an address that is not https", kTryLater);
    }
    return to;
  }

  [[noreturn]] void fail_to_transfer(const std::string& address,
                                     const TransferAnswer& answer) const {
    const std::string host = host_of(address);
    const std::string detail = answer.detail.empty() ? "" : " (" + answer.detail + ")";
    switch (answer.end) {
      case TransferEnd::no_library: {
        std::string remedy = answer.detail;
        if (remedy.ends_with('.')) remedy.pop_back();
        fail("this installation cannot fetch files", remedy);
      }
      case TransferEnd::unknown_host:
      case TransferEnd::not_connected:
        fail(host + " cannot be reached" + detail, kCheckConnection);
      case TransferEnd::bad_certificate:
        fail("the connection to " + host + " is not safe" + detail,
             "Check the date of this computer, its certificates (ca-certificates) and the proxy");
      case TransferEnd::too_slow:
        fail(host + " sent nearly nothing for " + std::to_string(options_.stall_seconds) + " s",
             kTryLater);
      case TransferEnd::broken_off:
        fail(host + " broke off before the end of the file", kTryLater);
      case TransferEnd::too_large:
        fail(host + " sent more than any such file has", kTryLater);
      default:
        fail("the transfer from " + host + " failed" + detail, kCheckConnection);
    }
  }

  [[noreturn]] void fail_by_status(const std::string& address, int status) const {
    const bool pdb = id_.archive == Archive::pdb;
    if (status == 404 || status == 410) {
      fail(pdb ? "the PDB has no entry of this id" : "AlphaFold DB has no model of this accession",
           "Check the id");
    }
    const std::string code = std::to_string(status);
    if (status == 429) fail(host_of(address) + " asks for fewer requests (429)", kTryLater);
    if (status == 407) fail("the proxy wants a name and a password (407)", kCheckConnection);
    fail(host_of(address) + " answered with the error " + code, kTryLater);
  }

  const MoleculeId& id_;
  const FetchOptions& options_;
  const RunContext& context_;
};

void require_mmcif(std::string_view text) {
  if (!looks_like_mmcif(text)) throw std::invalid_argument("something that is not an mmCIF file");
}

// All of the packed file is unpacked, so that one that was cut off is never kept.
void require_packed_mmcif(const std::string& body, const RunContext& context) {
  if (!body.starts_with("\x1f\x8b")) {
    throw std::invalid_argument("something that is not packed with gzip");
  }
  try {
    require_mmcif(unpack_gzip({}, body, ReadOptions{}.max_bytes, context).view());
  } catch (const ReadError& error) {
    throw std::invalid_argument("a file that cannot be unpacked (" + error.reason() + ")");
  }
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

fs::path fetch_pdb(const MoleculeId& id, const FetchOptions& options, const RunContext& context) {
  return Fetching(id, options, context)
      .file(server_for(id, options) + kPdbFolder + id.id + kPdbEnding, kLargestFile,
            [&](const std::string& body) { require_packed_mmcif(body, context); });
}

// AlphaFold DB gives models new versions. Its answer about an accession names the present one.
fs::path fetch_alphafold(const MoleculeId& id, const FetchOptions& options,
                         const RunContext& context) {
  const std::string server = server_for(id, options);
  Fetching fetching(id, options, context);
  const auto model = [&](const std::string& answer) {
    return address_of_model(answer, id.id, server);
  };
  const fs::path about = fetching.file(server + "/api/prediction/" + id.id, kLargestAnswer, model);
  std::string address;
  try {
    address = model(text_of(about));
  } catch (const std::invalid_argument& error) {  // it was right when it was fetched
    fetching.fail("the file " + about.string() + " is " + error.what(), "Remove it");
  }
  return fetching.file(address, kLargestFile, require_mmcif);
}

std::optional<MoleculeId> valid_id(const std::string& text) {
  try {
    return molecule_id(text);
  } catch (const InvalidId&) {
    return std::nullopt;
  }
}

}  // namespace

FetchOptions fetch_options_of_environment() {
  FetchOptions options;
  options.folder = fetched_files_folder();
  if (const char* const offline = std::getenv("ALPHASCOPE_OFFLINE")) {
    options.offline = *offline != '\0' && std::string_view(offline) != "0";
  }
  if (const char* const base = std::getenv("ALPHASCOPE_FETCH_BASE")) options.base = base;
  if (!options.base.empty() &&
      (!is_loopback(options.base) || options.base != server_of(options.base))) {
    throw std::invalid_argument(
        "ALPHASCOPE_FETCH_BASE is not an address of this computer, such as "
        "http://127.0.0.1:8080. Correct or unset it");
  }
  return options;
}

FetchedMolecule fetch_molecule(const MoleculeId& id, const FetchOptions& options,
                               const RunContext& context) {
  context.report("fetching " + id.text(), 0);
  FetchedMolecule fetched;
  fetched.file = id.archive == Archive::pdb ? fetch_pdb(id, options, context)
                                            : fetch_alphafold(id, options, context);
  if (const auto from = fetched_from(fetched.file, options.folder)) fetched.from = *from;
  return fetched;
}

std::string server_for(const MoleculeId& id, const FetchOptions& options) {
  if (!options.base.empty()) return options.base;
  return id.archive == Archive::pdb ? kPdbServer : kAlphaFoldServer;
}

std::optional<FetchedMolecule> fetched_before(const MoleculeId& id, const FetchOptions& options) {
  FetchOptions kept = options;
  kept.offline = true;
  kept.again = false;
  try {
    return fetch_molecule(id, kept, {});
  } catch (const ReadError&) {
    return std::nullopt;
  }
}

std::optional<MoleculeId> id_of_fetched(const fs::path& file) {
  const std::string name = file.filename().string();
  const fs::path folder = file.parent_path(), host = folder.parent_path();
  const std::string server =
      host.parent_path().filename().string() + "://" + host.filename().string();
  const bool packed = name.ends_with(kPdbEnding);
  if (server != (packed ? kPdbServer : kAlphaFoldServer) && !is_loopback(server)) return {};
  if (packed && folder.filename() == "download") {
    auto id = valid_id("pdb:" + name.substr(0, name.find('.')));
    if (id && id->id + kPdbEnding == name) return id;
  } else if (!packed && folder.filename() == "files" && name.starts_with("AF-")) {
    auto id = valid_id("af:" + name.substr(3, std::min(name.find('-', 3), name.size()) - 3));
    if (id && is_name_of_model(name, id->id)) return id;
  }
  return {};
}

bool is_loopback(const std::string& address) {
  if (!address.starts_with("https://") && !address.starts_with("http://")) return false;
  std::string host = host_of(address);
  const std::size_t bracket = host.starts_with('[') ? host.find(']') : 0;
  const std::size_t colon = bracket == host.npos ? host.npos : host.find(':', bracket);
  const std::string port = colon == host.npos ? "" : host.substr(colon + 1);
  if (port.find_first_not_of("0123456789") != port.npos) return false;
  host = host.substr(0, colon);
  return host == "localhost" || host == "127.0.0.1" || host == "[::1]";
}

}  // namespace alphascope
