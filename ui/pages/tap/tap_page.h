// The page of the tap test: measure (or open files), look at the modes, and what speed and depth follow. GUI thread.
#pragma once

#include <array>

#include "ui/pages/page.h"

class QHBoxLayout;
class QStackedWidget;
class QVBoxLayout;

namespace stillcut::ui {

class FrfPlot;
class TapController;
class TapLobePlot;
class TapPart;
class TouchButton;

class TapPage : public Page {
  Q_OBJECT
 public:
  // Null: there is nothing to measure with here; the page says so.
  explicit TapPage(TapController* controller, QWidget* parent = nullptr);

  void see(const Picture& picture) override;
  void display(const Picture& picture) override;
  void keep(QSettings& settings) const override;
  void restore(const QSettings& settings) override;
  void applyTheme(const Theme& theme) override;

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void showPart(int part);
  void showAxis(int axis);
  void refresh();

  TapController* controller_;
  int axis_ = 0;
  UnitSystem units_ = UnitSystem::Metric;
  QHBoxLayout* steps_ = nullptr;
  QStackedWidget *parts_ = nullptr, *plots_ = nullptr;
  std::vector<TouchButton*> buttons_;
  std::array<TouchButton*, 2> axes_{};
  std::vector<TapPart*> each_;
  FrfPlot* frf_ = nullptr;
  TapLobePlot* lobes_ = nullptr;
};

}  // namespace stillcut::ui
