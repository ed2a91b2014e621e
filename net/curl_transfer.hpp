// SPDX-License-Identifier: GPL-3.0-or-later
// One GET request by libcurl.
#pragma once

#include "core/document/fetch/transfer.hpp"

namespace alphascope {

TransferAnswer curl_get(const TransferRequest& request, const RunContext& context);

}  // namespace alphascope
