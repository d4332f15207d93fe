#include "core/active/fxlms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "tests/unit/active/plain.h"

namespace stillcut::active {
namespace {

constexpr double kRate = 5000.0;
const PathModel kPath{{0.0, 0.5, 0.3, -0.1}, {0.8, -0.5}};

std::vector<double> tone(std::size_t count, double frequency, double amplitude = 1.0) {
  std::vector<double> d(count);
  for (std::size_t n = 0; n < count; ++n) {
    d[n] = amplitude * std::sin(2.0 * std::numbers::pi * frequency / kRate * static_cast<double>(n) + 0.3);
  }
  return d;
}

double rms(const std::vector<double>& x, std::size_t from) {
  double sum = 0.0;
  for (std::size_t n = from; n < x.size(); ++n) sum += x[n] * x[n];
  return std::sqrt(sum / static_cast<double>(x.size() - from));
}

// The loop around a controller: `truth` is the path as it is.
std::vector<double> run(FxlmsController& controller, const PathModel& truth, const std::vector<double>& d,
                        const std::vector<double>& reference, double limit = HUGE_VAL) {
  PathFilter path;
  path.prepare(truth);
  std::vector<double> errors;
  for (std::size_t n = 0; n < d.size(); ++n) {
    const double e = d[n] - path.arrive();
    errors.push_back(e);
    const double y = std::clamp(controller.process(e, reference.empty() ? 0.0 : reference[n]), -limit, limit);
    controller.written(y);
    path.push(y);
  }
  return errors;
}

FxlmsController made(Reference reference, const LmsOptions& filter, const PathModel& model = kPath) {
  FxlmsController controller;
  controller.prepare({filter, reference, {}}, model, Hertz(kRate));
  return controller;
}

// eq. 2 and 3a with lists: feedforward, error as reference, internal model.
TEST(Fxlms, AgreesWithTheEquationsWrittenOut) {
  const std::size_t count = 400;
  const std::size_t taps = 12;
  const double mu = 0.002;
  const double leak = 0.9995;
  const auto d = whiteNoise(count, 1);
  const auto own = whiteNoise(count, 2);
  for (const Reference kind : {Reference::Feedforward, Reference::ErrorFeedback, Reference::InternalModel}) {
    std::vector<double> y(count, 0.0), x(count, 0.0), r(count, 0.0), heard(count, 0.0), filtered(count, 0.0);
    std::vector<double> e(count, 0.0), w(taps, 0.0);
    const PathModel model{{0.0, 0.45, 0.35}, {0.7, -0.4}};  // not quite the path
    const auto arrives = [](const PathModel& p, const std::vector<double>& in, std::vector<double>& out,
                            std::size_t n) {
      for (std::size_t k = 0; k < p.forward.size(); ++k) out[n] += p.forward[k] * past(in, n, k + 1);
      for (std::size_t k = 0; k < p.backward.size(); ++k) out[n] += p.backward[k] * past(out, n, k + 1);
    };
    for (std::size_t n = 0; n < count; ++n) {
      arrives(kPath, y, r, n);
      e[n] = d[n] - r[n];
      arrives(model, y, heard, n);
      x[n] = kind == Reference::Feedforward ? own[n] : kind == Reference::ErrorFeedback ? e[n] : e[n] + heard[n];
      arrives(model, x, filtered, n);
      for (std::size_t k = 0; k < taps; ++k) y[n] += w[k] * past(x, n, k);
      for (std::size_t k = 0; k < taps; ++k) w[k] = leak * w[k] + 2.0 * mu * e[n] * past(filtered, n, k);
    }
    FxlmsController controller = made(kind, {.taps = static_cast<int>(taps), .step = mu, .leak = leak}, model);
    const auto errors = run(controller, kPath, d, own);
    for (std::size_t n = 0; n < count; ++n) ASSERT_NEAR(errors[n], e[n], 1e-10) << static_cast<int>(kind) << " " << n;
    for (std::size_t k = 0; k < taps; ++k) EXPECT_NEAR(controller.weights()[k], w[k], 1e-10);
  }
}

// White reference, disturbance through a path of its own: the optimum is P/S (below eq. 5); here it has a finite form.
TEST(Fxlms, FeedforwardConvergesToTheWienerSolution) {
  const PathModel secondary{{0.0, 1.0}, {}};  // two samples of delay
  const auto x = whiteNoise(60000, 3);
  std::vector<double> d(x.size());
  for (std::size_t n = 0; n < x.size(); ++n) d[n] = 0.7 * past(x, n, 2) - 0.3 * past(x, n, 3) + 0.1 * past(x, n, 5);
  FxlmsController controller = made(Reference::Feedforward, {.taps = 8, .step = 0.002}, secondary);
  const auto e = run(controller, secondary, d, x);
  const std::vector<double> optimum{0.7, -0.3, 0.0, 0.1, 0.0, 0.0, 0.0, 0.0};
  for (std::size_t k = 0; k < optimum.size(); ++k) EXPECT_NEAR(controller.weights()[k], optimum[k], 1e-6);
  EXPECT_LT(rms(e, 50000), 1e-6);
}

TEST(Fxlms, InternalModelRemovesATone) {
  for (double f : {339.0, 471.0, 1024.0}) {
    const auto d = tone(20000, f);
    FxlmsController controller = made(Reference::InternalModel, {.taps = 35, .step = 0.1, .normalised = true});
    const auto e = run(controller, kPath, d, {});
    EXPECT_LT(20.0 * std::log10(rms(e, 19000) / rms(d, 19000)), -40.0) << f;
  }
}

TEST(Fxlms, ErrorAsReferenceReducesATone) {
  const auto d = tone(20000, 471.0);
  FxlmsController controller =
      made(Reference::ErrorFeedback, {.taps = 35, .step = 0.002, .leak = 0.9999, .normalised = true});
  const auto e = run(controller, kPath, d, {});
  EXPECT_LT(rms(e, 19000), 0.5 * rms(d, 19000));
}

// A model whose phase is wrong by more than 90 degrees at the tone steps the wrong way; by less, it converges.
TEST(Fxlms, NinetyDegreesIsTheLimitOfThePhaseError) {
  const double f = 500.0;
  const auto d = tone(12000, f);
  const auto x = tone(12000, f);
  const PathModel truth{{0.0, 0.0, 1.0}, {}};
  for (double degrees : {0.0, 60.0, 80.0, -80.0, 100.0, -100.0, 180.0}) {
    // a two-tap model with the gain of the truth and its phase turned at f
    const double w = 2.0 * std::numbers::pi * f / kRate;
    const std::complex<double> wanted =
        truth.response(Hertz(f), Hertz(kRate)) * std::polar(1.0, degrees * std::numbers::pi / 180.0);
    const std::complex<double> z1 = std::polar(1.0, -w);
    const std::complex<double> z2 = z1 * z1;
    const double b =
        (wanted.imag() * z1.real() - wanted.real() * z1.imag()) / (z2.imag() * z1.real() - z2.real() * z1.imag());
    const double a = (wanted.real() - b * z2.real()) / z1.real();
    const PathModel model{{a, b}, {}};
    ASSERT_NEAR(phaseError(model, truth.response(Hertz(f), Hertz(kRate)), Hertz(f), Hertz(kRate)),
                std::remainder(degrees * std::numbers::pi / 180.0, 2.0 * std::numbers::pi), 1e-9);
    FxlmsController controller = made(Reference::Feedforward, {.taps = 8, .step = 0.002}, model);
    const auto e = run(controller, truth, d, x, 1e6);
    if (std::abs(degrees) < 90.0) {
      EXPECT_LT(rms(e, 11000), 0.05) << degrees;
    } else {
      EXPECT_GT(rms(e, 11000), 10.0) << degrees;
    }
  }
}

TEST(Fxlms, TheAutomaticBoundSeparatesConvergenceFromDivergence) {
  const auto x = whiteNoise(30000, 5);
  std::vector<double> d(x.size());
  for (std::size_t n = 0; n < x.size(); ++n) d[n] = 0.7 * past(x, n, 4);
  for (const auto& [share, converges] : {std::pair{0.1, true}, std::pair{0.3, true}, std::pair{4.0, false}}) {
    FxlmsController controller =
        made(Reference::Feedforward, {.taps = 16, .step = share, .normalised = true}, {{0.0, 0.0, 1.0}, {}});
    const auto e = run(controller, {{0.0, 0.0, 1.0}, {}}, d, x, 1e6);
    EXPECT_EQ(rms(e, 29000) < 0.1 * rms(d, 29000), converges) << share;
    EXPECT_GT(controller.largestStep(), 0.0);
  }
}

// eq. 2 with the error and the filtered reference both weighted, written out.
TEST(Fxlms, TheWeightedLawAgreesWithTheEquationsWrittenOut) {
  const std::size_t count = 600;
  const std::size_t taps = 12;
  const double mu = 2e-5;
  const double gain = 20.0;
  const double width = 60.0;
  const double line = 700.0;
  const auto d = whiteNoise(count, 1);
  std::vector<double> y(count, 0.0), x(count, 0.0), r(count, 0.0), filtered(count, 0.0), e(count, 0.0);
  std::vector<double> w(taps, 0.0), we(count, 0.0), wf(count, 0.0);
  const double root = std::sqrt(gain);
  const double angle = 2.0 * std::numbers::pi * line / kRate;
  const double alpha = 0.5 * std::sin(angle) * width / line;
  const auto weigh = [&](const std::vector<double>& in, std::vector<double>& out, std::size_t n) {
    out[n] =
        ((1.0 + alpha * root) * in[n] - 2.0 * std::cos(angle) * past(in, n, 1) + (1.0 - alpha * root) * past(in, n, 2) +
         2.0 * std::cos(angle) * past(out, n, 1) - (1.0 - alpha / root) * past(out, n, 2)) /
        (1.0 + alpha / root);
  };
  const auto arrives = [](const std::vector<double>& in, std::vector<double>& out, std::size_t n) {
    for (std::size_t k = 0; k < kPath.forward.size(); ++k) out[n] += kPath.forward[k] * past(in, n, k + 1);
    for (std::size_t k = 0; k < kPath.backward.size(); ++k) out[n] += kPath.backward[k] * past(out, n, k + 1);
  };
  for (std::size_t n = 0; n < count; ++n) {
    arrives(y, r, n);
    e[n] = d[n] - r[n];
    x[n] = e[n] + r[n];
    arrives(x, filtered, n);
    weigh(e, we, n);
    weigh(filtered, wf, n);
    for (std::size_t k = 0; k < taps; ++k) y[n] += w[k] * past(x, n, k);
    for (std::size_t k = 0; k < taps; ++k) w[k] += 2.0 * mu * we[n] * past(wf, n, k);
  }
  FxlmsController controller;
  controller.prepare(
      {{.taps = static_cast<int>(taps), .step = mu}, Reference::InternalModel, {{Hertz(line)}, gain, Hertz(width)}},
      kPath, Hertz(kRate));
  const auto errors = run(controller, kPath, d, {});
  for (std::size_t n = 0; n < count; ++n) ASSERT_NEAR(errors[n], e[n], 1e-9) << n;
  for (std::size_t k = 0; k < taps; ++k) EXPECT_NEAR(controller.weights()[k], w[k], 1e-9);
}

// Two tones and a filter too short to take both out whole: the one that is asked for goes, however faint.
TEST(Fxlms, AFaintLineThatIsAskedForIsQuietenedBesideALoudOne) {
  auto d = tone(60000, 471.0, 10.0);
  const auto faint = tone(60000, 1000.0, 0.5);
  for (std::size_t n = 0; n < d.size(); ++n) d[n] += faint[n];
  const auto left = [&](const Emphasis& emphasis) {
    FxlmsController controller;
    controller.prepare({{.taps = 3, .step = 0.02, .normalised = true}, Reference::InternalModel, emphasis}, kPath,
                       Hertz(kRate));
    const auto e = run(controller, kPath, d, {});
    double cosine = 0.0;
    double sine = 0.0;
    for (std::size_t n = 55000; n < 60000; ++n) {  // a second: whole periods of both
      const double angle = 2.0 * std::numbers::pi * 1000.0 / kRate * static_cast<double>(n);
      cosine += e[n] * std::cos(angle) / 2500.0;
      sine += e[n] * std::sin(angle) / 2500.0;
    }
    return std::hypot(cosine, sine);
  };
  const double plain = left({});
  const double asked = left({{Hertz(1000.0)}, 200.0, Hertz(40.0)});
  EXPECT_GT(plain, 0.5);  // what LMS alone makes of it: no less than there was
  EXPECT_LT(asked, 0.1 * plain);
}

// With leak gamma the optimum moves away from the full solution: less output, less attenuation, never zero error.
TEST(Fxlms, LeakKeepsSomeOfTheVibration) {
  const auto d = tone(30000, 471.0);
  double before = 0.0;
  for (double leak : {1.0, 0.9999, 0.999}) {
    FxlmsController controller = made(Reference::InternalModel, {.taps = 35, .step = 0.002, .leak = leak});
    const double left = rms(run(controller, kPath, d, {}), 29000);
    EXPECT_GT(left, 1.5 * before) << leak;
    before = left;
  }
}

// A limited output: the weights stop growing, and once the disturbance is small again control is back soon.
TEST(Fxlms, DoesNotWindUpWhileTheOutputIsLimited) {
  auto d = tone(40000, 471.0, 20.0);
  for (std::size_t n = 20000; n < d.size(); ++n) d[n] *= 0.01;
  FxlmsController controller = made(Reference::InternalModel, {.taps = 35, .step = 0.05, .normalised = true});
  const auto e = run(controller, kPath, d, {}, 1.0);
  EXPECT_TRUE(std::isfinite(rms(e, 0)));
  EXPECT_LT(rms({e.begin() + 24000, e.end()}, 0), 0.3 * rms({d.begin() + 24000, d.end()}, 0));
}

TEST(Fxlms, ChangingStepAndLeakMakesNoJump) {
  const auto d = tone(8000, 471.0);
  FxlmsController controller = made(Reference::InternalModel, {.taps = 35, .step = 0.002});
  PathFilter path;
  path.prepare(kPath);
  double before = 0.0;
  double largest = 0.0;
  for (std::size_t n = 0; n < d.size(); ++n) {
    if (n == 5000) controller.setStep(0.004);
    if (n == 6000) controller.setLeak(0.9999);
    const double y = controller.process(d[n] - path.arrive());
    controller.written(y);
    path.push(y);
    if (n > 4900) largest = std::max(largest, std::abs(y - before));
    before = y;
  }
  // A tone of this size moves by at most amplitude x 2 pi f/rate a sample.
  EXPECT_LT(largest, 1.2 * 2.0 * std::numbers::pi * 471.0 / kRate * 2.5);
}

}  // namespace
}  // namespace stillcut::active
