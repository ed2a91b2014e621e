// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the answer of AlphaFold DB about an accession: a list of models in JSON.
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>

#include "core/document/fetch/fetch.hpp"

namespace alphascope {
namespace {

using nlohmann::json;

std::string text_at(const json& model, const char* key) {
  const auto found = model.find(key);
  return found != model.end() && found->is_string() ? found->get<std::string>() : std::string();
}

}  // namespace

bool is_name_of_model(std::string_view name, const std::string& accession) {
  const std::string begin = "AF-" + accession + "-F1-model_v";
  if (!name.starts_with(begin) || !name.ends_with(".cif")) return false;
  name.remove_prefix(begin.size());
  name.remove_suffix(4);
  return !name.empty() && name.size() <= 4 &&
         name.find_first_not_of("0123456789") == std::string_view::npos;
}

// The answer may also list models of isoforms and of complexes, which have other names.
std::string address_of_model(const std::string& answer, const std::string& accession,
                             const std::string& server) {
  const json models = json::parse(answer, nullptr, /*allow_exceptions=*/false);
  if (!models.is_array() || models.empty()) {
    throw std::invalid_argument("an answer that is not a list of models");
  }
  const std::string folder = server + "/files/";
  bool elsewhere = false;
  for (const json& model : models) {
    if (!model.is_object()) continue;
    const std::string address = text_at(model, "cifUrl");
    if (address.starts_with(folder) &&
        is_name_of_model(std::string_view(address).substr(folder.size()), accession)) {
      return address;
    }
    elsewhere = elsewhere || !address.empty();
  }
  throw std::invalid_argument(
      elsewhere ? "an answer that names no model of this accession on its own server"
                : "an answer that names no file");
}

}  // namespace alphascope
