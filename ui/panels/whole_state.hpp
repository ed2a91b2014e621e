// Includes view_state.hpp and the types that it only declares. Sources that make or copy a
// ViewState need it; panels do not.
#pragma once

#include "ui/colour_legend.hpp"
#include "ui/panels/molecule/radius_row.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/picture_marks.hpp"
