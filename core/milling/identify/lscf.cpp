#include "core/milling/identify/lscf.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>

#include "core/base/units.h"

namespace stillcut::identify {
namespace {

using Complex = std::complex<double>;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;

constexpr double kArc = 0.9;  // fraction of the unit circle the band takes
constexpr double kLargestDamping = 0.3;

// Sums of z^d, H z^d and |H|^2 z^d over the lines, d = 0 .. order: the normal equations are Toeplitz in them.
struct Moments {
  VectorXcd one, value, square;  // d >= 0
  VectorXcd valueBack;           // sum of H z^-d
};

Moments momentsOf(const ModalLines& lines, int order) {
  Moments m;
  m.one = m.value = m.square = m.valueBack = VectorXcd::Zero(order + 1);
  const double scale = lines.value.cwiseAbs().maxCoeff();
  const double width = lines.to - lines.from;
  for (Eigen::Index i = 0; i < lines.frequency.size(); ++i) {
    const double angle = kTwoPi * kArc * ((lines.frequency[i] - lines.from) / width - 0.5);
    const Complex step = std::polar(1.0, angle);
    const Complex h = lines.value[i] / scale;
    Complex z = 1.0;
    for (int d = 0; d <= order; ++d, z *= step) {
      m.one[d] += z;
      m.value[d] += h * z;
      m.valueBack[d] += h * std::conj(z);
      m.square[d] += std::norm(h) * z;
    }
  }
  return m;
}

// Reduced normal matrix of the denominator: T - S^H R^-1 S.
MatrixXcd reducedMatrix(const Moments& m, int size) {
  MatrixXcd r(size, size);
  MatrixXcd s(size, size);
  MatrixXcd t(size, size);
  for (int j = 0; j < size; ++j) {
    for (int k = 0; k < size; ++k) {
      const int d = k - j;
      r(j, k) = d >= 0 ? m.one[d] : std::conj(m.one[-d]);
      t(j, k) = d >= 0 ? m.square[d] : std::conj(m.square[-d]);
      s(j, k) = d >= 0 ? -m.value[d] : -m.valueBack[-d];
    }
  }
  return t - s.adjoint() * r.ldlt().solve(s);
}

std::vector<ModalPole> polesOfOrder(const Moments& m, const ModalLines& lines, int order) {
  const MatrixXcd full = reducedMatrix(m, order + 1);
  const VectorXcd a =
      -full.bottomRightCorner(order, order).completeOrthogonalDecomposition().solve(full.col(0).tail(order));
  std::vector<ModalPole> poles;
  if (!a.allFinite()) return poles;
  // 1 + a_1 z + .. + a_n z^n = 0 with y = 1/z: y^n + a_1 y^(n-1) + .. + a_n = 0.
  MatrixXcd companion = MatrixXcd::Zero(order, order);
  companion.row(0) = -a.transpose();
  companion.bottomLeftCorner(order - 1, order - 1).setIdentity();
  const Eigen::ComplexEigenSolver<MatrixXcd> solver(companion, false);
  if (solver.info() != Eigen::Success) return poles;
  const double width = lines.to - lines.from;
  for (const Complex y : solver.eigenvalues()) {
    if (std::abs(y) < 1e-12) continue;
    const Complex l = -std::log(y);
    const double damped = (l.imag() / (kTwoPi * kArc) + 0.5) * width + lines.from;
    const double decay = -l.real() / (kTwoPi * kArc) * width;  // both in Hz
    const double natural = std::hypot(damped, decay);
    if (damped <= 0.0 || decay <= 0.0 || decay >= kLargestDamping * natural) continue;
    poles.push_back({natural, decay / natural});
  }
  std::sort(poles.begin(), poles.end(), [](auto& p, auto& q) { return p.frequency < q.frequency; });
  return poles;
}

struct Track {
  std::vector<ModalPole> poles;
  int first = 0;  // order of its first and last pole
  int last = 0;
};

bool continues(const ModalPole& before, const ModalPole& now) {
  return std::abs(now.frequency - before.frequency) < 0.01 * before.frequency &&
         std::abs(now.damping - before.damping) < std::max(0.1 * before.damping, 0.001);
}

double median(std::vector<double> v) {
  const auto middle = v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2);
  std::nth_element(v.begin(), middle, v.end());
  return *middle;
}

StablePole summary(const Track& track) {
  std::vector<double> f;
  std::vector<double> d;
  for (const ModalPole& p : track.poles) {
    f.push_back(p.frequency);
    d.push_back(p.damping);
  }
  return {{median(f), median(d)}, static_cast<int>(track.poles.size())};
}

std::vector<Track> followOrders(const std::vector<std::vector<ModalPole>>& byOrder) {
  std::vector<Track> tracks;
  for (int order = 0; order < static_cast<int>(byOrder.size()); ++order) {
    const std::size_t open = tracks.size();
    for (const ModalPole& pole : byOrder[static_cast<std::size_t>(order)]) {
      Track* best = nullptr;
      for (std::size_t i = 0; i < open; ++i) {
        Track& track = tracks[i];
        if (track.last != order - 1 || !continues(track.poles.back(), pole)) continue;
        const auto distance = [&](const Track& t) { return std::abs(t.poles.back().frequency - pole.frequency); };
        if (!best || distance(track) < distance(*best)) best = &track;
      }
      if (best) {
        best->poles.push_back(pole);
        best->last = order;
      } else {
        tracks.push_back({{pole}, order, order});
      }
    }
  }
  return tracks;
}

}  // namespace

std::vector<std::vector<ModalPole>> lscfPoles(const ModalLines& lines, int highestOrder) {
  const Moments moments = momentsOf(lines, highestOrder);
  std::vector<std::vector<ModalPole>> byOrder;
  byOrder.reserve(static_cast<std::size_t>(highestOrder));
  for (int order = 2; order <= highestOrder; ++order) byOrder.push_back(polesOfOrder(moments, lines, order));
  return byOrder;
}

std::vector<StablePole> stablePoles(const std::vector<std::vector<ModalPole>>& byOrder) {
  std::vector<Track> tracks = followOrders(byOrder);
  // Longest first; a shorter one that was never there together with a longer one near it is the same pole.
  std::stable_sort(tracks.begin(), tracks.end(),
                   [](const Track& a, const Track& b) { return a.poles.size() > b.poles.size(); });
  std::vector<Track> kept;
  for (Track& track : tracks) {
    if (track.poles.size() < 2) continue;
    const ModalPole pole = summary(track).pole;
    Track* same = nullptr;
    for (Track& other : kept) {
      const bool apart = track.first > other.last || track.last < other.first;
      if (apart && std::abs(summary(other).pole.frequency - pole.frequency) < 0.012 * pole.frequency) same = &other;
    }
    if (same) {
      same->poles.insert(same->poles.end(), track.poles.begin(), track.poles.end());
      same->first = std::min(same->first, track.first);
      same->last = std::max(same->last, track.last);
    } else {
      kept.push_back(std::move(track));
    }
  }
  std::vector<StablePole> out;
  out.reserve(kept.size());
  for (const Track& track : kept) out.push_back(summary(track));
  std::stable_sort(out.begin(), out.end(), [](auto& a, auto& b) { return a.seen > b.seen; });
  return out;
}

}  // namespace stillcut::identify
