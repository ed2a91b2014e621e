// SPDX-License-Identifier: GPL-3.0-or-later
// Makes charts of cavity curves and traces, finds splits and joins on curves, and writes CSV.
#include "core/document/cavities/cavity_chart.hpp"

#include <optional>

#include "core/cavity_identity/cavity_curves.hpp"
#include "core/cavity_identity/cavity_trace.hpp"
#include "core/complex/face_class.hpp"
#include "core/geometry/shortest_number.hpp"
#include "core/predicates/orthosphere.hpp"
#include "core/text/grouped_number.hpp"
#include "core/write/csv.hpp"

namespace alphascope {
namespace {

constexpr std::uint32_t kNone = CavityMatch::kNone;

double value_of(const CurveCavity& cavity, CurveQuantity quantity) {
  return quantity == CurveQuantity::volume   ? cavity.volume_sa_angstrom3
         : quantity == CurveQuantity::area   ? cavity.area_sa_angstrom2
         : quantity == CurveQuantity::mouths ? static_cast<double>(cavity.mouths)
                                             : cavity.volume_exact_angstrom3;
}

CavityChart empty_chart(CurveAxis axis, CurveQuantity quantity) {
  CavityChart chart;
  chart.chart.kind = ChartKind::lines;
  chart.chart.id = "cavity-curves";
  chart.chart.title = "Cavities";
  chart.chart.value_label = quantity_label(quantity);
  chart.chart.x_label = axis_label(axis);
  return chart;
}

// The value of a cavity or of totals. None if the trace does not have this quantity.
template <class Traced>
std::optional<double> traced_value(const Traced& of, CurveQuantity quantity) {
  if (quantity == CurveQuantity::volume) return of.volume_sa_angstrom3;
  if (quantity == CurveQuantity::area) return of.area_sa_angstrom2;
  if (quantity == CurveQuantity::mouths) return static_cast<double>(of.mouths);
  return {};
}

// A series with a value of each point.
template <class Value>
ChartSeries traced_series(const CavityTrace& trace, const std::string& name, const Value& value) {
  ChartSeries series;
  series.name = name;
  for (const auto& point : trace.points) {
    series.x.push_back(point->solvent_radius_angstrom);
    series.values.push_back(value(*point));
  }
  return series;
}

ChartSeries series_named(const CavityCurves& curves, const std::string& name) {
  ChartSeries series;
  series.name = name;
  for (const CurveSample& sample : curves.samples) series.x.push_back(sample.at);
  series.values.resize(curves.samples.size());
  return series;
}

const char* name_of_total(bool voids) {
  return voids ? "all voids" : "all pockets";
}

const char* unit_of(CurveAxis axis) {
  return axis == CurveAxis::alpha ? " Å²" : axis == CurveAxis::solvent ? " Å" : "";
}

// Finds the samples at which a cavity splits, joins others, begins or ends.
class Marks {
 public:
  Marks(const CavityCurves& curves, const std::vector<std::uint32_t>& line, std::size_t series,
        std::vector<CurveMark>& marks)
      : curves_(curves), line_(line), series_(series), marks_(marks) {}

  void find() {
    if (curves_.axis == CurveAxis::model) return;
    for (std::size_t n = 1; n < line_.size(); ++n) {
      if (line_[n - 1] != kNone && line_[n] != kNone) {
        on_the_way(n);
      } else if (line_[n] != kNone) {
        begins(n);
      } else if (line_[n - 1] != kNone) {
        ends(n);
      }
    }
  }

 private:
  void on_the_way(std::size_t n) {
    const CurveSample& sample = curves_.samples[n];
    const std::size_t parts = parts_at(sample, line_[n - 1]),
                      sources = sources_at(sample, line_[n]);
    if (parts > 1) add(n, between(n) + " it splits into " + grouped(parts) + " cavities.");
    if (sources > 1) add(n, between(n) + " " + grouped(sources) + " cavities join in it.");
  }
  void begins(std::size_t n) {
    if (curves_.samples[n].from_last.came_from[line_[n]] == kNone) return;
    add(n, "Below " + text(n) + unit() + " it is a part of a larger cavity.");
  }
  void ends(std::size_t n) {
    if (curves_.samples[n].from_last.goes_to[line_[n - 1]] == kNone) return;
    add(n - 1, "Above " + text(n - 1) + unit() + " it is a part of a larger cavity.");
  }
  std::string text(std::size_t n) const { return axis_text(curves_.axis, curves_.samples[n].at); }
  std::string unit() const { return unit_of(curves_.axis); }
  std::string between(std::size_t n) const {
    return "Between " + text(n - 1) + " and " + text(n) + unit();
  }
  void add(std::size_t n, const std::string& what) { marks_.push_back({series_, n, what}); }

  const CavityCurves& curves_;
  const std::vector<std::uint32_t>& line_;
  const std::size_t series_;
  std::vector<CurveMark>& marks_;
};

}  // namespace

CurveNumbers numbers_for(CurveQuantity quantity) {
  return quantity == CurveQuantity::exact_volume ? CurveNumbers::exact : CurveNumbers::sums;
}

std::string quantity_label(CurveQuantity quantity) {
  return quantity == CurveQuantity::volume   ? "SA volume (Å³)"
         : quantity == CurveQuantity::area   ? "SA area (Å²)"
         : quantity == CurveQuantity::mouths ? "mouths"
                                             : "exact volume (Å³)";
}

std::string quantity_unit(CurveQuantity quantity) {
  return quantity == CurveQuantity::area ? "Å²" : quantity == CurveQuantity::mouths ? "" : "Å³";
}

std::string axis_label(CurveAxis axis) {
  return axis == CurveAxis::alpha     ? "alpha (Å²)"
         : axis == CurveAxis::solvent ? "solvent radius (Å)"
                                      : "model";
}

std::string axis_text(CurveAxis axis, double at) {
  if (axis == CurveAxis::model) return grouped(static_cast<std::uint64_t>(at) + 1);
  return shortest_number(at);
}

CavityChart chart_of_cavities(const CavityCurves& curves, CurveQuantity quantity,
                              const CurveLinks& links, const std::vector<ChartedCavity>& chosen) {
  CavityChart chart = empty_chart(curves.axis, quantity);
  for (const ChartedCavity& cavity : chosen) {
    const std::vector<std::uint32_t>& line = links.of.at(cavity.cavity);
    ChartSeries series = series_named(curves, cavity.name);
    for (std::size_t n = 0; n < line.size(); ++n) {
      if (line[n] == kNone) continue;
      series.values[n] = value_of(curves.samples[n].cavities[line[n]], quantity);
    }
    Marks(curves, line, chart.chart.series.size(), chart.marks).find();
    chart.chart.series.push_back(std::move(series));
  }
  return chart;
}

CavityChart chart_of_totals(const CavityCurves& curves, CurveQuantity quantity) {
  CavityChart chart = empty_chart(curves.axis, quantity);
  for (const bool voids : {true, false}) {
    ChartSeries series = series_named(curves, name_of_total(voids));
    for (std::size_t n = 0; n < curves.samples.size(); ++n) {
      if (!curves.samples[n].known) continue;
      double sum = 0;
      for (const CurveCavity& cavity : curves.samples[n].cavities) {
        if (cavity.is_void == voids) sum += value_of(cavity, quantity);
      }
      series.values[n] = sum;
    }
    chart.chart.series.push_back(std::move(series));
  }
  return chart;
}

CavityChart chart_of_trace(const CavityTrace& trace, CurveQuantity quantity,
                           const std::vector<TracedSeries>& chosen) {
  CavityChart chart = empty_chart(CurveAxis::solvent, quantity);
  chart.traced.assign(trace.points.size(), true);
  for (const TracedSeries& one : chosen) {
    chart.chart.series.push_back(traced_series(trace, one.name, [&](const TracedPoint& point) {
      const TracedCavity* cavity = point.find(one.number);
      return cavity ? traced_value(*cavity, quantity) : std::nullopt;
    }));
  }
  return chart;
}

CavityChart totals_of_trace(const CavityTrace& trace, CurveQuantity quantity) {
  CavityChart chart = empty_chart(CurveAxis::solvent, quantity);
  chart.traced.assign(trace.points.size(), true);
  for (const bool voids : {true, false}) {
    chart.chart.series.push_back(
        traced_series(trace, name_of_total(voids), [&](const TracedPoint& point) {
          return traced_value(voids ? point.voids : point.pockets, quantity);
        }));
  }
  return chart;
}

CavityChart with_trace(const CavityChart& whole, const CavityChart& trace) {
  if (whole.chart.series.empty() || trace.chart.series.empty()) return whole;
  const std::vector<double>&a = whole.chart.series.front().x, &b = trace.chart.series.front().x;
  CavityChart both = whole;
  both.traced.clear();
  for (ChartSeries& series : both.chart.series) {
    series.x.clear();
    series.values.clear();
  }
  std::vector<std::size_t> place(a.size());  // of samples of `whole` among both
  for (std::size_t i = 0, k = 0; i < a.size() || k < b.size();) {
    const bool of_whole = i < a.size() && (k == b.size() || a[i] <= b[k]);
    const bool of_trace = k < b.size() && (i == a.size() || b[k] <= a[i]);
    const CavityChart& from = of_whole ? whole : trace;
    const std::size_t n = of_whole ? i : k;
    for (std::size_t s = 0; s < both.chart.series.size(); ++s) {
      both.chart.series[s].x.push_back(of_whole ? a[i] : b[k]);
      both.chart.series[s].values.push_back(from.chart.series[s].values[n]);
    }
    if (of_whole) place[i] = both.traced.size();
    both.traced.push_back(of_trace);
    i += of_whole;
    k += of_trace;
  }
  for (CurveMark& mark : both.marks) mark.sample = place[mark.sample];
  return both;
}

std::string chart_csv(const Chart& chart, const std::vector<std::string>& comments) {
  CsvRow names{{chart.x_label, ""}};
  for (const ChartSeries& series : chart.series) names.emplace_back(series.name, "");
  std::string text = csv_comments(comments) + csv_names(names);
  const std::size_t rows = chart.series.empty() ? 0 : chart.series.front().x.size();
  for (std::size_t n = 0; n < rows; ++n) {
    text += shortest_number(chart.series.front().x[n]);
    for (const ChartSeries& series : chart.series) {
      text += "," + (series.values[n] ? shortest_number(*series.values[n]) : std::string());
    }
    text += "\n";
  }
  return text;
}

}  // namespace alphascope
