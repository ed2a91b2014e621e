// The derived results that everything else hangs on.
#pragma once

#include "core/complex/triangulation.hpp"
#include "core/document/store/definition.hpp"
#include "core/engine/known_of_balls.hpp"
#include "core/triangulation/filtration.hpp"

namespace alphascope {

class Store;

// Of all balls, CGAL's, on one thread.
const Definition<Triangulation>& whole_triangulation();

// All simplices with their alpha values: any alpha is a threshold of it.
const Definition<Filtration>& whole_filtration();

// Both, as far as the store has them, for a request of the same balls.
OfAllBalls of_all_balls(const Store& store, const Inputs& inputs);
// Has the store take them, or drop what it has no room for. They are of the same balls.
void give_of_all_balls(Store& store, const Inputs& inputs, const OfAllBalls& made);

}  // namespace alphascope
