// Viridis: a palette of even steps for the eye, readable without colour vision and in grey.
// Source: S. van der Walt and N. Smith, matplotlib (2015), public domain (CC0); here its published 20-step form.
#pragma once

#include <QRgb>
#include <array>

namespace stillcut::ui {

using ColorTable = std::array<QRgb, 256>;

// Index 0 is the lowest level.
const ColorTable& viridis();

}  // namespace stillcut::ui
