// stillcut._core: what the Python package stillcut (stillcut/__init__.py) is made of. Python's own code checks shapes
// and makes its types; here is only what has to be compiled. Each call lets other Python threads run.

#include <pybind11/complex.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <mutex>
#include <utility>

#include "app/python/answer.h"
#include "core/detect/registry.h"
#include "core/milling/identify/modal_fit.h"
#include "core/model/judged_cut.h"
#include "generated/version.h"

namespace stillcut::app {
namespace {

namespace py = pybind11;
using Samples = py::array_t<float, py::array::c_style | py::array::forcecast>;  // frames x channels
using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;
using ComplexNumbers = py::array_t<std::complex<double>, py::array::c_style | py::array::forcecast>;

template <class T>
std::vector<T> listOf(const py::array_t<T, py::array::c_style | py::array::forcecast>& array) {
  return {array.data(), array.data() + array.size()};
}
std::span<const float> spanOf(const Samples& samples) {
  return {samples.data(), static_cast<std::size_t>(samples.size())};
}

std::string analyze(const Samples& samples, double rate, const std::string& sensor, double scale, int teeth,
                    double speed, const std::vector<std::string>& detectors, const Settings& settings) {
  const Sampled about{rate, static_cast<int>(samples.shape(1)), sensor, scale, teeth, speed};
  const std::span<const float> all = spanOf(samples);
  const py::gil_scoped_release others;
  return analyzeSamples(about, all, detectors, settings);
}

// One method, fed block by block.
class Fed {
 public:
  Fed(const std::string& method, double rate, int channels, const std::string& sensor, double scale, int teeth,
      double speed, const Settings& settings) {
    auto run = BlockRun::build(optionsOf({rate, channels, sensor, scale, teeth, speed}, {method}, settings));
    if (!run) throw std::invalid_argument(run.error().line());
    run_ = std::move(run).value();
  }

  py::list feed(const Samples& samples, double measured) {
    std::vector<Verdict> verdicts;
    const std::span<const float> all = spanOf(samples);
    {
      const py::gil_scoped_release others;
      const std::scoped_lock turn(one_);  // one thread at a time, whatever Python's do
      run_->feed(all, Rpm(measured),
                 [&verdicts](const StepInput&, const StepOutput& out) { verdicts.push_back(out.verdicts.front()); });
    }
    py::list list;
    for (const Verdict& v : verdicts) list.append(asDict(v));
    return list;
  }

 private:
  py::dict asDict(const Verdict& v) const {
    py::dict d;
    const bool judged = hasState(v);
    d["time"] = sinceEpoch(v.time).value;
    d["state"] = judged ? std::string(name(v.state)) : "not-judged";
    d["phase"] = std::string(name(v.phase));
    d["reason"] = sentence(judged ? v.reason : whyNotJudged(v));
    d["frequency"] = v.frequency.value;
    d["energy_ratio"] = v.severity.value;
    d["speed"] = toRpm(v.spindle).value;
    d["kind"] = std::string(name(v.kind));
    d["early_warning"] = v.earlyWarning;
    py::dict indicators;
    std::size_t k = 0;
    for (const std::string_view label : run_->chain().parts().detectors.front()->describe().indicators)
      indicators[py::str(std::string(label))] = v.indicators[k++];
    d["indicators"] = std::move(indicators);
    return d;
  }

  std::unique_ptr<BlockRun> run_;
  std::mutex one_;
};

milling::CutModel modelOf(const py::dict& cut) {
  milling::CutModel model;
  for (const py::handle& entry : cut["modes"]) {
    const auto mode = py::cast<std::vector<double>>(entry);  // frequency, damping, stiffness, along x, along y
    model.modes.push_back({Hertz(mode.at(0)), mode.at(1), mode.at(2), {mode.at(3), mode.at(4)}});
  }
  model.tool.teeth = py::cast<int>(cut["teeth"]);
  model.tool.diameter = Metres(py::cast<double>(cut["diameter"]));
  model.tool.helix = py::cast<double>(cut["helix"]);
  model.material.tangential = py::cast<double>(cut["tangential"]);
  model.material.radial = py::cast<double>(cut["radial"]);
  model.engagement.radialImmersion = py::cast<double>(cut["immersion"]);
  model.engagement.side = py::cast<bool>(cut["down"]) ? milling::MillingDirection::Down : milling::MillingDirection::Up;
  return model;
}

std::string lobes(const py::dict& cut, const Numbers& speeds, double deepest, const std::string& method) {
  const LobesAsked asked{modelOf(cut), listOf(speeds), deepest, method};
  const py::gil_scoped_release others;
  return lobesOf(asked);
}

identify::ModalFit fitted(const identify::Frf& frf, const identify::ModalOptions& options) {
  const py::gil_scoped_release others;
  auto fit = identify::fitModes(frf, options);
  if (!fit) throw std::invalid_argument(fit.error().line());
  return std::move(fit).value();
}

py::dict fitModes(const Numbers& frequency, const ComplexNumbers& value, const std::string& quantity,
                  const Numbers& coherence, double from, double to, int modes) {
  identify::Frf frf;
  frf.frequency = listOf(frequency);
  frf.value = listOf(value);
  frf.coherence = listOf(coherence);
  frf.quantity = quantity == "accelerance" ? identify::FrfQuantity::Accelerance
                 : quantity == "mobility"  ? identify::FrfQuantity::Mobility
                                           : identify::FrfQuantity::Compliance;
  frf.source = "frequency response";
  identify::ModalOptions options;
  options.from = from;
  options.to = to;
  options.modes = modes;
  const identify::ModalFit fit = fitted(frf, options);
  py::list found;
  for (const identify::IdentifiedMode& m : fit.modes) {
    py::dict mode;
    mode["frequency"] = m.mode.frequency.value;
    mode["damping"] = m.mode.damping;
    mode["stiffness"] = m.mode.stiffness;
    mode["frequency_sd"] = m.frequencySd;
    mode["damping_sd"] = m.dampingSd;
    mode["stiffness_sd"] = m.stiffnessSd;
    found.append(std::move(mode));
  }
  std::vector<std::string> remarks;
  for (const Message& remark : fit.remarks) remarks.push_back(text(remark));
  py::dict d;
  d["modes"] = std::move(found);
  d["misfit"] = fit.misfit;
  d["band"] = py::make_tuple(fit.from, fit.to);
  d["remarks"] = remarks;
  d["frequency"] = Numbers(static_cast<py::ssize_t>(fit.frequency.size()), fit.frequency.data());
  d["measured"] = ComplexNumbers(static_cast<py::ssize_t>(fit.measured.size()), fit.measured.data());
  d["fitted"] = ComplexNumbers(static_cast<py::ssize_t>(fit.fitted.size()), fit.fitted.data());
  return d;
}

std::vector<std::string> detectorNames() {
  std::vector<std::string> names;
  for (const detect::DetectorRow& row : detect::detectorTable()) names.emplace_back(row.id);
  return names;
}

}  // namespace
}  // namespace stillcut::app

// NOLINTNEXTLINE(*): what the macro makes is pybind11's
PYBIND11_MODULE(_core, module) {
  using namespace stillcut::app;  // NOLINT(google-build-using-namespace)
  module.attr("version") = STILLCUT_VERSION;
  module.def("detectors", &detectorNames);
  module.def("analyze", &analyze);
  module.def("lobes", &lobes);
  module.def("fit_modes", &fitModes);
  py::class_<Fed>(module, "Fed")
      .def(py::init<const std::string&, double, int, const std::string&, double, int, double, const Settings&>())
      .def("feed", &Fed::feed);
}
