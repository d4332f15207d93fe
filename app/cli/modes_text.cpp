#include "app/cli/modes_text.h"

#include <cstdio>

#include "core/milling/identify/model_files.h"

namespace stillcut::app {

using namespace identify;

void printModes(const AxisModes& axis) {
  const ModalFit& fit = axis.fit;
  std::printf("axis %s, band %.0f to %.0f Hz\n", std::string(name(axis.axis)).c_str(), fit.from, fit.to);
  std::printf("misfit of these modes %.1f %%, with residuals %.1f %%, with complex shapes too %.1f %%\n",
              100.0 * fit.writtenMisfit, 100.0 * fit.realMisfit, 100.0 * fit.misfit);
  std::printf("deepest negative real part %.3g m/N as measured, %.3g m/N of these modes\n", fit.measuredDepth,
              fit.writtenDepth);
  const bool coherent = !axis.frf.coherence.empty();
  std::printf("%14s %18s %24s %7s %10s%s  %s\n", "frequency/Hz", "damping", "stiffness/(N/m)", "share", "-Re/(m/N)",
              coherent ? "  coherence" : "", "doubt");
  for (const IdentifiedMode& m : fit.modes) {
    std::printf("%8.1f +-%4.1f %8.4f +-%7.4f %12.3e +-%9.1e %5.0f %% %10.2e", m.mode.frequency.value, m.frequencySd,
                m.mode.damping, m.dampingSd, m.mode.stiffness, m.stiffnessSd, 100.0 * m.share, m.depth);
    if (coherent) std::printf(" %10.3f", m.coherence);
    std::printf("  %s\n", m.caveat.c_str());
  }
  for (const Message& remark : axis.remarks) std::printf("%s\n", text(remark).c_str());
}

Status saveAxes(const std::vector<AxisModes>& axes, const std::string& source, const std::string& out) {
  ModesFile all;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (axes[i].axis == Axis::Z) return measuredAlongZ(axes[i].frf.source);
    const std::array<double, 2> direction =
        axes[i].axis == Axis::Y ? std::array<double, 2>{0.0, 1.0} : std::array<double, 2>{1.0, 0.0};
    const ModesFile file = modesFile(axes[i].fit, source, direction);
    all = i == 0 ? file : joined(all, file);
  }
  return saveModes(all, out);
}

}  // namespace stillcut::app
