// SPDX-License-Identifier: GPL-3.0-or-later
// Asks for the results that shown columns need beside the rows themselves, and takes them.
#include <memory>

#include "core/document/cavities/cavity_contents.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/document/channels/channel_results.hpp"
#include "core/document/store/store.hpp"
#include "ui/panels/cavities/cavity_columns.hpp"
#include "ui/panels/cavities/cavity_page.hpp"
#include "ui/panels/cavities/cavity_parts.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

template <class T>
void take(CavityPage& page, std::shared_ptr<const T>& to, const Derived<T>& from) {
  if (!from.ready() || from.value == to) return;
  to = from.value;
  page.rows_are_old = true;
}

}  // namespace

void follow_column_results(PanelContext& ctx, CavityPage& page, bool current) {
  const auto shown = [&](const char* column) { return is_shown(page, column); };
  if (!current) {
    // The store makes the contents in one job with the rows, so both come together.
    if (shown("holds")) ctx.store.want(cavity_contents(), ctx.inputs);
    return;
  }
  take(page, page.rows.exact, ctx.store.want(cavity_volumes(), ctx.inputs));
  if (shown("holds")) {
    take(page, page.rows.contents, ctx.store.want(cavity_contents(), ctx.inputs));
  }
  if (shown("depth_angstrom")) {
    take(page, page.rows.depths, ctx.store.want(cavity_depths(), ctx.inputs));
  }
  if (shown("born_alpha_angstrom2") || shown("gone_alpha_angstrom2")) {
    take(page, page.rows.lives, ctx.store.want(whole_cavity_lives(), ctx.inputs));
  }
  if (shown("bottleneck_angstrom")) {
    take(page, page.rows.bottlenecks, ctx.store.want(cavity_bottlenecks(), ctx.inputs));
  }
}

}  // namespace alphascope
