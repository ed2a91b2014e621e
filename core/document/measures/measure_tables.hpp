// SPDX-License-Identifier: GPL-3.0-or-later
// The table of areas and volumes on screen as CSV or JSON text, equal to that of the command line.
#pragma once

#include <memory>
#include <string>

namespace alphascope {

struct Answer;
template <class T>
struct Definition;
struct MeasureQuery;
struct RecordSource;

// The rows of a query as CSV or JSON, with provenance.
Definition<std::string> measure_csv(const MeasureQuery& query, const RecordSource& source,
                                    const std::shared_ptr<const Answer>& answer);
Definition<std::string> measure_json(const MeasureQuery& query, const RecordSource& source,
                                     const std::shared_ptr<const Answer>& answer);

}  // namespace alphascope
