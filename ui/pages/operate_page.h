// The operator page: one verdict, one recommendation; everything else supports them. Shows pictures, asks by signals;
// knows no session.
#pragma once

#include <QWidget>
#include <vector>

#include "core/model/operator_input.h"
#include "ui/models/advice_view.h"
#include "ui/models/column_reader.h"
#include "ui/models/machine_view.h"
#include "ui/models/session_info.h"
#include "ui/models/severity_trend.h"
#include "ui/models/themed.h"

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

class OperatePage : public QWidget, public Themed {
  Q_OBJECT
 public:
  explicit OperatePage(QWidget* parent = nullptr);

  // At the display tick, GUI thread.
  void display(const Picture& picture);
  void applyTheme(const Theme& theme) override;

 signals:
  void asked(const stillcut::OperatorInput& input);

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
  ColumnReader columns_;
  SeverityTrend trend_;
  std::uint32_t adviceShown_ = 0;
  MoveReason moveReason_;
  VibrationScale vibrationScale_;
};

}  // namespace stillcut::ui
