// SPDX-License-Identifier: GPL-3.0-or-later
// Words the options for ids in place of files.
#include "app/options/fetch_flags.hpp"

#include "app/options/option_values.hpp"

namespace alphascope {

Option offline_option(bool& offline) {
  return flag_option("--offline", "Fetch nothing: an id names a file that was fetched before",
                     offline);
}

Option fetch_again_option(bool& fetch_again) {
  return flag_option("--fetch-again", "Fetch an id even if its file was fetched before",
                     fetch_again);
}

}  // namespace alphascope
