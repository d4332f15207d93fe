#include "core/milling/stability/characteristic.h"

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace stillcut::milling {

namespace {

constexpr std::size_t kMostTerms = 128;
constexpr double kTailTolerance = 1e-8;   // last terms, against the smallest size of f on the circle
constexpr double kNoiseTolerance = 1e-6;  // the same where a large Psi leaves a floor of rounding noise
constexpr double kRangeLimit = 1e8;       // largest against smallest f: beyond, rounding reaches the small values

// det(H - mu I) for an upper Hessenberg matrix: elimination with a pivot from two neighbouring rows.
Complex hessenbergDeterminant(const Eigen::MatrixXcd& h, Complex mu, Eigen::MatrixXcd& work) {
  const Eigen::Index n = h.rows();
  work = h;
  work.diagonal().array() -= mu;
  Complex det = 1.0;
  for (Eigen::Index k = 0; k + 1 < n; ++k) {
    if (std::norm(work(k + 1, k)) > std::norm(work(k, k))) {
      work.row(k).swap(work.row(k + 1));
      det = -det;
    }
    const Complex pivot = work(k, k);
    det *= pivot;
    if (pivot == 0.0) return 0.0;
    const Complex factor = work(k + 1, k) / pivot;
    for (Eigen::Index j = k + 1; j < n; ++j) work(k + 1, j) -= factor * work(k, j);
  }
  return det * work(n - 1, n - 1);
}

// Operations of characteristicCoefficients(): reduction to Hessenberg form and one determinant per state, complex.
double coefficientEffort(int states) {
  const double n = states;
  return 40.0 * n * n * n;
}

// One value of f's s-dependence: coefficient vectors on the circle, nodes in the order of their angle.
class CircleNodes {
 public:
  CircleNodes(const TransitionMatrix& transition, Complex centre, double radius, WorkMeter& meter)
      : transition_(transition), meter_(meter), centre_(centre), radius_(radius), real_(centre.imag() == 0.0) {}

  std::size_t count() const { return count_; }
  std::size_t inner() const { return static_cast<std::size_t>(transition_.states()) - 1; }
  double smallest() const { return smallest_; }
  double largest() const { return largest_; }
  const Complex& value(std::size_t node, std::size_t k) const { return values_[node * inner() + k]; }

  // Doubles the nodes (or starts with 16), evaluating only the new ones; a real centre needs only the upper half.
  bool refine() {
    const std::size_t wanted = count_ == 0 ? 16 : 2 * count_;
    std::vector<Complex> next(wanted * inner());
    std::vector<std::size_t> fresh;
    for (std::size_t j = 0; j < wanted; ++j) {
      if (count_ != 0 && j % 2 == 0) {
        std::copy_n(values_.begin() + static_cast<std::ptrdiff_t>(j / 2 * inner()), inner(),
                    next.begin() + static_cast<std::ptrdiff_t>(j * inner()));
      } else if (!real_ || 2 * j <= wanted) {
        fresh.push_back(j);
      }
    }
    values_ = std::move(next);
    count_ = wanted;
    return evaluate(fresh);
  }

 private:
  bool evaluate(const std::vector<std::size_t>& fresh) {
    const auto n = static_cast<std::size_t>(transition_.states());
    std::vector<Complex> s;
    std::vector<Complex> psi(8 * n * n);
    std::vector<Complex> c(n);
    for (std::size_t first = 0; first < fresh.size(); first += 8) {
      const std::size_t lanes = std::min<std::size_t>(8, fresh.size() - first);
      s.clear();
      for (std::size_t b = 0; b < lanes; ++b) {
        s.push_back(centre_ +
                    std::polar(radius_, kTwoPi * static_cast<double>(fresh[first + b]) / static_cast<double>(count_)));
      }
      if (!transition_.evaluate(s, psi, meter_)) return false;
      for (std::size_t b = 0; b < lanes; ++b) {
        if (!meter_.proceed(coefficientEffort(transition_.states()))) return false;
        characteristicCoefficients(std::span(psi).subspan(b * n * n, n * n), transition_.states(),
                                   transition_.determinant(), c);
        store(fresh[first + b], c);
      }
    }
    return std::isfinite(largest_);
  }

  void store(std::size_t node, const std::vector<Complex>& c) {
    double size = 1.0;  // the leading coefficient
    for (std::size_t k = 0; k < inner(); ++k) {
      values_[node * inner() + k] = c[k + 1];
      size = std::max(size, std::abs(c[k + 1]));
      if (real_ && node != 0 && 2 * node != count_) values_[(count_ - node) * inner() + k] = std::conj(c[k + 1]);
      if (!std::isfinite(std::abs(c[k + 1]))) size = std::numeric_limits<double>::infinity();
    }
    largest_ = std::max(largest_, size);
    smallest_ = std::min(smallest_, size);
  }

  const TransitionMatrix& transition_;
  WorkMeter& meter_;
  Complex centre_;
  double radius_;
  bool real_;
  std::size_t count_ = 0;
  std::vector<Complex> values_;
  double largest_ = 0.0;
  double smallest_ = std::numeric_limits<double>::infinity();
};

// Taylor coefficients in z = (s - centre)/radius: [power][k].
std::vector<Complex> expand(const CircleNodes& nodes) {
  const std::size_t m = nodes.count();
  const std::size_t inner = nodes.inner();
  std::vector<Complex> turn(m);
  for (std::size_t j = 0; j < m; ++j) turn[j] = std::polar(1.0, -kTwoPi * static_cast<double>(j) / double(m));
  std::vector<Complex> c(m * inner);
  for (std::size_t j = 0; j < m; ++j) {
    for (std::size_t l = 0; l < m; ++l) {
      const Complex w = turn[(j * l) % m] / double(m);
      for (std::size_t k = 0; k < inner; ++k) {
        const Complex v = nodes.value(l, k);
        c[j * inner + k] +=
            Complex(w.real() * v.real() - w.imag() * v.imag(), w.real() * v.imag() + w.imag() * v.real());
      }
    }
  }
  return c;
}

// Number of powers worth keeping, or 0 when the series has not converged.
std::size_t convergedTerms(const std::vector<Complex>& c, std::size_t inner, double tolerance) {
  const std::size_t m = c.size() / inner;
  std::size_t last = 0;
  for (std::size_t j = 0; j < m; ++j) {
    for (std::size_t k = 0; k < inner; ++k) {
      if (std::abs(c[j * inner + k]) > tolerance) last = j;
    }
  }
  return last + 3 > m ? 0 : last + 1;
}

}  // namespace

void characteristicCoefficients(std::span<const Complex> psi, int states, double determinant, std::span<Complex> out) {
  const Eigen::Map<const Eigen::MatrixXcd> matrix(psi.data(), states, states);
  out[0] = determinant;
  if (states == 2) {
    out[1] = -(matrix(0, 0) + matrix(1, 1));
    return;
  }
  const auto n = static_cast<std::size_t>(states);
  const Eigen::MatrixXcd h = Eigen::HessenbergDecomposition<Eigen::MatrixXcd>(matrix).matrixH();
  Eigen::MatrixXcd work(states, states);
  std::vector<Complex> turn(n);
  std::vector<Complex> values(n);
  for (std::size_t j = 0; j < n; ++j) {
    turn[j] = std::polar(1.0, kTwoPi * static_cast<double>(j) / static_cast<double>(n));
    values[j] = hessenbergDeterminant(h, turn[j], work) - 1.0;  // (-mu)^n = 1 there, n being even
  }
  for (std::size_t k = 1; k < n; ++k) {
    Complex sum = 0.0;
    for (std::size_t j = 0; j < n; ++j) sum += values[j] * std::conj(turn[(j * k) % n]);
    out[k] = sum / static_cast<double>(n);
  }
}

std::optional<Characteristic> Characteristic::build(const TransitionMatrix& transition, Complex centre, double radius,
                                                    WorkMeter& meter) {
  CircleNodes nodes(transition, centre, radius, meter);
  while (nodes.count() < kMostTerms) {
    if (!nodes.refine()) return std::nullopt;
    if (nodes.largest() > kRangeLimit * nodes.smallest()) return std::nullopt;
    const auto m = static_cast<double>(nodes.count());
    if (!meter.proceed(8.0 * m * m * static_cast<double>(nodes.inner()))) return std::nullopt;
    const std::vector<Complex> c = expand(nodes);
    const double tolerance = nodes.count() < 64 ? kTailTolerance : kNoiseTolerance;
    const std::size_t terms = convergedTerms(c, nodes.inner(), tolerance * nodes.smallest());
    if (terms == 0) continue;
    Characteristic result;
    result.centre_ = centre;
    result.radius_ = radius;
    result.states_ = transition.states();
    result.inner_ = nodes.inner();
    result.constant_ = transition.determinant();
    for (std::size_t i = 0; i < terms * nodes.inner(); ++i) {
      result.re_.push_back(c[i].real());
      result.im_.push_back(c[i].imag());
    }
    return result;
  }
  return std::nullopt;
}

CharacteristicValue Characteristic::at(Complex mu, Complex s) const {
  constexpr std::size_t kMost = 64;
  std::array<double, 6 * kMost> a{};  // re, im of the value, the first and half the second derivative, per power of mu
  std::vector<double> large;
  double* v = a.data();
  if (inner_ > kMost) {
    large.assign(6 * inner_, 0.0);
    v = large.data();
  }
  double* const vi = v + inner_;
  double* const d = vi + inner_;
  double* const di = d + inner_;
  double* const e = di + inner_;
  double* const ei = e + inner_;
  const Complex z = (s - centre_) / radius_;
  const double x = z.real();
  const double y = z.imag();
  for (std::size_t j = re_.size(); j > 0; j -= inner_) {
    const double* const cr = re_.data() + (j - inner_);
    const double* const ci = im_.data() + (j - inner_);
    for (std::size_t k = 0; k < inner_; ++k) {
      const double er = e[k] * x - ei[k] * y + d[k];
      ei[k] = e[k] * y + ei[k] * x + di[k];
      e[k] = er;
      const double dr = d[k] * x - di[k] * y + v[k];
      di[k] = d[k] * y + di[k] * x + vi[k];
      d[k] = dr;
      const double vr = v[k] * x - vi[k] * y + cr[k];
      vi[k] = v[k] * y + vi[k] * x + ci[k];
      v[k] = vr;
    }
  }
  CharacteristicValue r{1.0, 0.0, 0.0, 0.0, 0.0, 0.0};  // the leading coefficient, then Horner in mu
  for (std::size_t k = inner_ + 1; k > 0; --k) {
    const bool last = k == 1;
    r.fmm = r.fmm * mu + 2.0 * r.fm;
    r.fm = r.fm * mu + r.f;
    r.fsm = r.fsm * mu + r.fs;
    r.f = r.f * mu + (last ? Complex(constant_) : Complex(v[k - 2], vi[k - 2]));
    r.fs = r.fs * mu + (last ? Complex(0.0) : Complex(d[k - 2], di[k - 2]));
    r.fss = r.fss * mu + (last ? Complex(0.0) : Complex(2 * e[k - 2], 2 * ei[k - 2]));
  }
  const double scale = 1.0 / radius_;
  r.fs *= scale;
  r.fsm *= scale;
  r.fss *= scale * scale;
  return r;
}

Complex Characteristic::valueAt(Complex mu, Complex s) const {
  const Complex z = (s - centre_) / radius_;
  Complex f = 1.0;
  for (std::size_t k = inner_; k > 0; --k) {
    Complex c = 0.0;
    for (std::size_t j = re_.size(); j > 0; j -= inner_) {
      c = Complex(c.real() * z.real() - c.imag() * z.imag() + re_[j - inner_ + k - 1],
                  c.real() * z.imag() + c.imag() * z.real() + im_[j - inner_ + k - 1]);
    }
    f = Complex(f.real() * mu.real() - f.imag() * mu.imag(), f.real() * mu.imag() + f.imag() * mu.real()) + c;
  }
  return f * mu + constant_;
}

}  // namespace stillcut::milling
