// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the pages, or tells where they were looked for.
#include "app/viewer/jobs/guide_reader.hpp"

#include <memory>
#include <string>

#include "core/document/guide/guide.hpp"
#include "core/text/printable.hpp"
#include "ui/panels/guide/guide_state.hpp"

namespace alphascope {

bool GuideReader::poll(GuideState& state) {
  const bool news = worker_.poll() > 0;
  if (state.shown && !state.guide && state.problem.empty() && !busy()) read(state);
  return news;
}

void GuideReader::read(GuideState& state) {
  worker_.submit(
      [this, &state](const RunContext&) -> Worker::Delivery {
        auto guide = std::make_shared<const Guide>(load_guide(docs_));
        return [&state, guide] { state.guide = guide; };
      },
      [this, &state](const Worker::Failure& failure) {
        state.problem = failure.message + "\n\nThe guide was looked for in " +
                        printable((docs_ / "guide").string()) +
                        ". It is in the package alphascope-data, and in the folder docs of the "
                        "sources. Install or build the program again, then open the guide again.";
      });
}

}  // namespace alphascope
