// SPDX-License-Identifier: GPL-3.0-or-later
// How programs fetch molecules by their id. The library that asks servers is loaded at the first
// request, so a program that fetches nothing starts without libcurl.
#pragma once

#include <filesystem>
#include <vector>

#include "core/document/fetch/fetch.hpp"
#include "core/document/fetch/transfer.hpp"

namespace alphascope {

// Options for fetch_molecule() of the running program: those of the environment, with its library.
// Throws as fetch_options_of_environment() does.
FetchOptions fetch_options_of_program();

// Asks servers by the first library that exists. If it cannot be used, each answer says why.
Transfer transfer_of_library(const std::vector<std::filesystem::path>& places);

}  // namespace alphascope
