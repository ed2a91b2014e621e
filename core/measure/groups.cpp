#include <stdexcept>

#include "core/measure/exact_sum.hpp"
#include "core/measure/union_measures.hpp"

namespace alphascope {
namespace {

// Roots are the lowest balls of their trees.
class Forest {
 public:
  explicit Forest(std::size_t balls) : parent_(balls) {
    for (std::size_t i = 0; i < balls; ++i) parent_[i] = static_cast<BallIndex>(i);
  }
  BallIndex root(BallIndex i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(BallIndex i, BallIndex j) {
    i = root(i);
    j = root(j);
    if (i < j) {
      parent_[j] = i;
    } else {
      parent_[i] = j;
    }
  }

 private:
  std::vector<BallIndex> parent_;
};

}  // namespace

Components components(std::size_t balls, const AlphaComplex& complex) {
  Forest forest(balls);
  for (const auto& [i, j] : complex.edges.simplices) forest.join(i, j);
  Components of;
  of.of_ball.assign(balls, kNoGroup);
  for (const auto& [i] : complex.vertices.simplices) {
    const BallIndex root = forest.root(i);
    of.of_ball[i] = root == i ? of.count++ : of.of_ball[root];
  }
  return of;
}

std::vector<double> sums_by_group(std::span<const double> values,
                                  std::span<const std::uint32_t> group, std::size_t groups) {
  if (values.size() != group.size()) {
    throw std::invalid_argument("sums by group need one group for each value");
  }
  std::vector<NeumaierSum> sums(groups);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (group[i] == kNoGroup) continue;
    if (group[i] >= groups) throw std::invalid_argument("sums by group: no such group");
    sums[group[i]].add(values[i]);
  }
  std::vector<double> totals;
  totals.reserve(groups);
  for (const NeumaierSum& sum : sums) totals.push_back(sum.value());
  return totals;
}

}  // namespace alphascope
