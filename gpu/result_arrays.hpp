// From pinned memory, which the next run overwrites, to arrays that a complex keeps.
#pragma once

#include "gpu/facet_pipeline.hpp"

namespace alphascope::gpu {

// Fills the four lists of simplices, by all threads: most of it is the system handing out pages.
// Throws std::bad_alloc.
void copy_result(const PipelineResult& from, AlphaComplex& to);

}  // namespace alphascope::gpu
