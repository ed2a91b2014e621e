// SPDX-License-Identifier: GPL-3.0-or-later
// The derived results on which all others depend: triangulation and filtration.
#pragma once

namespace alphascope {

class Filtration;
template <class T>
struct Definition;
struct Inputs;
struct ResultsForAllAlphas;
struct Triangulation;

class Store;

// The triangulation of all balls (core/triangulation/triangulation_maker.hpp).
const Definition<Triangulation>& whole_triangulation();

// All simplices with their alpha values: any alpha is a threshold of it.
const Definition<Filtration>& whole_filtration();

// Both, as far as the store has them, for a request with the same balls.
ResultsForAllAlphas results_for_all_alphas(const Store& store, const Inputs& inputs);
// Gives both to the store, which drops them if it has no room. `made` is of the balls of `inputs`.
void give_results_for_all_alphas(Store& store, const Inputs& inputs,
                                 const ResultsForAllAlphas& made);

}  // namespace alphascope
