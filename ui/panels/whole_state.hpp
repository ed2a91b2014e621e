// ViewState with all types that its lists hold, for sources that make or copy one. Panels need
// view_state.hpp only.
#pragma once

#include "ui/colour_legend.hpp"
#include "ui/panels/molecule/radius_row.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/picture_marks.hpp"
