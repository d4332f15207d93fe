// The operator page: one verdict, one recommendation; everything else supports them. Shows pictures, asks by signals;
// knows no session.
#pragma once

#include <vector>

#include "ui/models/advice_view.h"
#include "ui/models/history/spectrum_column_reader.h"
#include "ui/models/machine_view.h"
#include "ui/models/severity_trend.h"
#include "ui/pages/page.h"

class QGridLayout;
class QVBoxLayout;

namespace stillcut::ui {

class AdvicePanel;
class InterventionList;
class LimitBar;
class OverrideTable;
class Panel;
class SpectrogramWidget;
class VerdictSign;

class OperatePage : public Page {
  Q_OBJECT
 public:
  explicit OperatePage(QWidget* parent = nullptr);

  void see(const Picture& picture) override;
  void display(const Picture& picture) override;
  void restart() override;
  void applyTheme(const Theme& theme) override;

 private:
  void showSpectrogram(const Picture& picture);
  void showBars(const Picture& picture);
  void space(const Theme& theme);

  VerdictSign* verdict_;
  AdvicePanel* advice_;
  SpectrogramWidget* spectrogram_;
  Panel* spectrogramPanel_;
  Panel* barsPanel_;
  Panel* machinePanel_;
  OverrideTable* overrides_;
  InterventionList* interventions_;
  QGridLayout* grid_;
  QVBoxLayout* barsLayout_;
  std::vector<LimitBar*> bars_;

  Theme theme_;
  SpectrumColumnReader columns_;
  SeverityTrend trend_;
  std::uint32_t adviceShown_ = 0;
  MoveReason moveReason_;
  VibrationScale vibrationScale_;
};

}  // namespace stillcut::ui
