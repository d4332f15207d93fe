// The page of the stability lobes: the diagram, computed in the background, the cut in it, and "what if". GUI thread.
#pragma once

#include <array>
#include <functional>
#include <memory>

#include "ui/models/lobe_view.h"
#include "ui/pages/page.h"

class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QProgressBar;
class QTableView;

namespace stillcut::ui {

class LobeChart;
class Panel;
class TextLabel;
class TouchButton;

class LobesPage : public Page {
  Q_OBJECT
 public:
  // Asked again after restart(): another cut has other lobes. May give null: the modes are not known.
  using FindService = std::function<LobeService*()>;
  explicit LobesPage(FindService find, QWidget* parent = nullptr);

  void display(const Picture& picture) override;
  void restart() override;
  void keep(QSettings& settings) const override;
  void restore(const QSettings& settings) override;
  void applyTheme(const Theme& theme) override;

 private:
  void layOut();
  void connectAll();
  void meet(LobeService* service, bool replay);
  void showWork(const Picture& picture);
  void compute();
  void chooseMethod(LobeMethodChoice method);
  void showProgress();
  void showDiagram();
  void showWhatIf();
  void fieldsChanged();
  void whatIfAsked();

  FindService find_;
  LobeService* service_ = nullptr;
  bool met_ = false;
  LobeMethodChoice method_ = LobeMethodChoice::Exact;
  struct Asked {
    QString tool;
    Rpm speed{};
    Metres depth{};
  } asked_;         // where somebody has put the ring
  QString absent_;  // why the working point is not shown, or does not move; empty: it does
  UnitSystem units_ = UnitSystem::Metric;
  std::shared_ptr<const LobeDiagram> diagram_;

  LobeChart* chart_;
  std::array<TouchButton*, 3> methods_;
  TouchButton* compute_;
  QProgressBar* progress_;
  QLabel* state_;
  QDoubleSpinBox* speed_;
  QDoubleSpinBox* depth_;
  TextLabel* verdict_;
  QLabel* detail_;
  QLabel* reach_;
  QTableView* pockets_;
  PocketTable* table_;
  Panel* side_;
  QGridLayout* grid_;
};

}  // namespace stillcut::ui
