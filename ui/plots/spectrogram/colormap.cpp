#include "ui/plots/spectrogram/colormap.h"

#include <cmath>

namespace stillcut::ui {
namespace {

constexpr std::array<QRgb, 20> kPoints{0x440154, 0x481567, 0x482677, 0x453781, 0x404788, 0x39568c, 0x33638d,
                                       0x2d708e, 0x287d8e, 0x238a8d, 0x1f968b, 0x20a387, 0x29af7f, 0x3cbb75,
                                       0x55c667, 0x73d055, 0x95d840, 0xb8de29, 0xdce319, 0xfde725};

int between(int a, int b, double part) {
  return static_cast<int>(std::lround(a + (b - a) * part));
}

ColorTable makeTable() {
  ColorTable table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double place = static_cast<double>(i) / 255.0 * static_cast<double>(kPoints.size() - 1);
    const auto low = std::min(static_cast<std::size_t>(place), kPoints.size() - 2);
    const double part = place - static_cast<double>(low);
    const QRgb a = kPoints[low], b = kPoints[low + 1];
    table[i] =
        qRgb(between(qRed(a), qRed(b), part), between(qGreen(a), qGreen(b), part), between(qBlue(a), qBlue(b), part));
  }
  return table;
}

}  // namespace

const ColorTable& viridis() {
  static const ColorTable kTable = makeTable();
  return kTable;
}

}  // namespace stillcut::ui
