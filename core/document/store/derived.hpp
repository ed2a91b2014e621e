// The derived results that everything else hangs on.
#pragma once

#include "core/complex/triangulation.hpp"
#include "core/document/store/definition.hpp"
#include "core/triangulation/filtration.hpp"

namespace alphascope {

// Of all balls, CGAL's, on one thread.
const Definition<Triangulation>& whole_triangulation();

// All simplices with their alpha values: any alpha is a threshold of it.
const Definition<Filtration>& whole_filtration();

}  // namespace alphascope
