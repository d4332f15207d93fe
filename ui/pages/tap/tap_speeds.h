// Third step of a tap test: material and engagement, and the speed and depth that follow. GUI thread.
#pragma once

#include "ui/pages/tap/tap_part.h"

namespace stillcut::ui {

class TextLabel;
class TouchButton;

class TapSpeeds : public TapPart {
  Q_OBJECT
 public:
  explicit TapSpeeds(TapController& controller, QWidget* parent = nullptr);
  void refresh(int axis, UnitSystem units) override;
  void keep(QSettings& settings) const override;
  void restore(const QSettings& settings) override;

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  TapCut typed() const;
  void fill(const TapCut& cut);
  void edited();

  UnitSystem units_ = UnitSystem::Metric;
  bool asked_ = false;
  QStringList tools_;  // that are offered
  QComboBox *material_, *side_;
  QDoubleSpinBox *teeth_, *diameter_, *width_, *feed_, *lowest_, *highest_, *deepest_;
  TextLabel *answer_, *detail_, *said_;
  QComboBox* tool_;
  TouchButton* keep_;
};

}  // namespace stillcut::ui
