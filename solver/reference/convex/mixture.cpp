#include "solver/reference/convex/mixture.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace plumb::reference::cores {
namespace {

constexpr std::size_t columns = 4;

/// The game as a linear program in its condensed tableau: of payoffs m_ij > 0, max sum z_j with sum_j m_ij z_j <= 1 and z >= 0. The
/// value is 1 / sum z; the duals are the weights of the rows over it.
class Tableau {
 public:
  explicit Tableau(std::vector<std::array<double, columns + 1>> rows) : rows_(std::move(rows)) {
    for (std::size_t i = 0; i < rows_.size(); ++i) row_names_.push_back(static_cast<int>(columns + i));
  }

  void solve() {
    constexpr int most_pivots = 60;
    for (int k = 0; k < most_pivots; ++k) {
      const std::size_t column = entering();
      if (column == columns) return;
      const std::size_t row = leaving(column);
      if (row == rows_.size()) return;
      pivot(row, column);
    }
  }

  /// Of the z_j, and of the duals of the rows, neither below 0.
  void read(std::array<double, columns>& z, std::vector<double>& duals) const {
    z.fill(0);
    duals.assign(rows_.size(), 0);
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (row_names_[i] < static_cast<int>(columns))
        z[static_cast<std::size_t>(row_names_[i])] = std::max(rows_[i][columns], 0.0);
    for (std::size_t j = 0; j < columns; ++j)
      if (column_names_[j] >= static_cast<int>(columns))
        duals[static_cast<std::size_t>(column_names_[j]) - columns] = std::max(gain_[j], 0.0);
  }

 private:
  [[nodiscard]] std::size_t entering() const {
    constexpr double nothing_to_gain = -1e-14;
    const auto least = std::min_element(gain_.begin(), gain_.end() - 1);
    return *least < nothing_to_gain ? static_cast<std::size_t>(least - gain_.begin()) : columns;
  }

  [[nodiscard]] std::size_t leaving(std::size_t column) const {
    constexpr double least_pivot = 1e-12;
    std::size_t out = rows_.size();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (rows_[i][column] < least_pivot) continue;
      const double ratio = rows_[i][columns] / rows_[i][column];
      if (ratio < least) {
        least = ratio;
        out = i;
      }
    }
    return out;
  }

  void pivot(std::size_t row, std::size_t column) {
    auto& top = rows_[row];
    const double inverse = 1 / top[column];
    const auto eliminate = [&](auto& line) {
      const double factor = line[column] * inverse;
      for (std::size_t j = 0; j <= columns; ++j)
        if (j != column) line[j] -= factor * top[j];
      line[column] = -factor;
    };
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (i != row) eliminate(rows_[i]);
    eliminate(gain_);
    for (std::size_t j = 0; j <= columns; ++j)
      if (j != column) top[j] *= inverse;
    top[column] = inverse;
    std::swap(row_names_[row], column_names_[column]);
  }

  std::vector<std::array<double, columns + 1>> rows_;
  std::array<double, columns + 1> gain_{-1, -1, -1, -1, 0};
  std::vector<int> row_names_;
  std::array<int, columns> column_names_{0, 1, 2, 3};
};

/// Over their sum, which is above 0.
template <class Weights>
void normalise(Weights& weights) {
  double sum = 0;
  for (const double w : weights) sum += w;
  for (double& w : weights) w /= sum;
}

struct Range {
  double least = std::numeric_limits<double>::infinity(), greatest = -least;
};

Range payoffs(const Points& points, const CornersOfCell& corners, std::vector<std::array<double, columns + 1>>& rows) {
  Range out;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < columns; ++j) {
      const double payoff = rows[i][j] = points[i].dot(corners[j]);
      out.least = std::min(out.least, payoff);
      out.greatest = std::max(out.greatest, payoff);
    }
  return out;
}

/// Of the affine hull of the points that a mask chooses: false where it is not inside their mixtures.
bool nearest_of(const Points& points, unsigned mask, std::vector<double>& weights) {
  std::array<std::size_t, 4> chosen{};
  if (std::popcount(mask) > static_cast<int>(chosen.size())) return false;  // no mixture needs more
  int count = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if ((mask >> i & 1U) != 0) chosen[static_cast<std::size_t>(count++)] = i;
  weights.assign(points.size(), 0);
  const Vec3<double>& base = points[chosen[0]];
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3> edges(3, count - 1);
  for (int k = 1; k < count; ++k) edges.col(k - 1) = points[chosen[static_cast<std::size_t>(k)]] - base;
  double first = 1;
  if (count > 1) {
    const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1> shares = edges.colPivHouseholderQr().solve(-base);
    for (int k = 1; k < count; ++k) weights[chosen[static_cast<std::size_t>(k)]] = shares[k - 1];
    first -= shares.sum();
  }
  weights[chosen[0]] = first;
  return std::all_of(weights.begin(), weights.end(), [](double w) { return w >= 0; });
}

}  // namespace

GameSolution best_mixture(const Points& points, const CornersOfCell& corners) {
  std::vector<std::array<double, columns + 1>> rows(points.size());
  const Range range = payoffs(points, corners, rows);
  const double width = range.greatest > range.least ? range.greatest - range.least : 1;
  for (auto& row : rows) {
    for (std::size_t j = 0; j < columns; ++j) row[j] = (row[j] - range.least) / width + 1;
    row[columns] = 1;
  }
  Tableau tableau(std::move(rows));
  tableau.solve();
  GameSolution out{};
  tableau.read(out.corner_weights, out.weights);
  normalise(out.corner_weights);
  normalise(out.weights);
  const Vec3<double> w = mixed(points, out.weights);
  out.value = std::numeric_limits<double>::infinity();
  for (const Vec3<double>& corner : corners) out.value = std::min(out.value, w.dot(corner));
  return out;
}

std::vector<double> nearest_mixture(const Points& points) {
  std::vector<double> best, weights;
  double least = std::numeric_limits<double>::infinity();
  for (unsigned mask = 1; mask < 1U << points.size(); ++mask) {
    if (!nearest_of(points, mask, weights)) continue;
    const double length = mixed(points, weights).norm();
    if (!(length < least)) continue;
    least = length;
    best = weights;
  }
  return best;
}

Vec3<double> mixed(const Points& points, const std::vector<double>& weights) {
  Vec3<double> out = Vec3<double>::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) out += weights[i] * points[i];
  return out;
}

}  // namespace plumb::reference::cores
