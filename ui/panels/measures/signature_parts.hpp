// SPDX-License-Identifier: GPL-3.0-or-later
// Functions that the sources of the page of the signature share.
#pragma once

#include <vector>

namespace alphascope {

struct Signature;
struct PanelContext;
struct Plot;
struct PlotRange;
struct Rgb8;

inline constexpr const char* kSimplexNames[] = {"vertices", "edges", "triangles", "tetrahedra"};

// Draws a check box for marks in the view: the simplices that appear at the present alpha.
void mark_appearing(PanelContext& ctx, bool& on);

// --- signature_plots.cpp

Rgb8 signature_colour(int dimension);
PlotRange signature_range(const PanelContext& ctx, const Signature& signature);  // of alpha
Plot plot_of_counts(const Signature& signature, const PlotRange& alpha,
                    const std::vector<double>& alphas);
Plot plot_of_euler(const Signature& signature, const PlotRange& alpha,
                   const std::vector<double>& alphas);
// All curves in one plot, at up to 500 round alphas.
Plot plot_of_all(const Signature& signature, const PlotRange& alpha);

// --- signature_saving.cpp

void signature_save_button(PanelContext& ctx, const Signature& signature);

}  // namespace alphascope
