// The page of the stability lobes: the diagram, computed in the background, the cut in it, and "what if"; of the cut
// that runs or is replayed, or of one that is entered here. GUI thread.
#pragma once

#include <array>
#include <functional>
#include <memory>

#include "ui/facade/lobe_entry.h"
#include "ui/models/lobe_view.h"
#include "ui/pages/page.h"

class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QHBoxLayout;
class QProgressBar;
class QStackedWidget;
class QTableView;

namespace stillcut::ui {

class CutForm;
class LobeChart;
class Panel;
class TextLabel;
class TouchButton;

class LobesPage : public Page {
  Q_OBJECT
 public:
  // Asked again after restart(): another cut has other lobes. May give null: the modes are not known.
  using FindService = std::function<LobeService*()>;
  // `entry` may be null: no cut can be entered. It outlives the page.
  explicit LobesPage(FindService find, LobeEntryController* entry = nullptr, QWidget* parent = nullptr);

  void display(const Picture& picture) override;
  void restart() override;
  void keep(QSettings& settings) const override;
  void restore(const QSettings& settings) override;
  void applyTheme(const Theme& theme) override;

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void layOut();
  void connectAll();
  QWidget* makeSources();
  void meet(LobeService* service, bool replay);
  void showAbsence(bool replay);
  void showOwn(bool own, bool editing);
  void showSources();
  void askCloser();
  void showAnswers();
  void showWork(const Picture& picture);
  void compute();
  void chooseMethod(LobeMethodChoice method);
  void showProgress();
  void showDiagram();
  void showWhatIf();
  void showNote(const SpeedDepth& at, const std::vector<Pocket>& pockets);
  void showLearned();
  void fieldsChanged();
  void whatIfAsked();

  FindService find_;
  LobeEntryController* entry_;
  LobeService* service_ = nullptr;
  bool own_ = false;  // the cut that was entered here, instead of the one that runs
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
  std::shared_ptr<const LobeCloseUp> closeUp_;
  std::shared_ptr<const LearnedLobes> learnedLobes_;

  LobeChart* chart_;
  QLabel* learned_;  // what the judged cuts say; under the diagram
  QStackedWidget* places_;
  QHBoxLayout* sources_ = nullptr;
  TouchButton *runs_ = nullptr, *entered_ = nullptr;  // whose lobes are shown
  CutForm* form_ = nullptr;                           // null: no cut can be entered
  std::array<TouchButton*, 3> methods_;
  TouchButton* compute_;
  QProgressBar* progress_;
  QLabel* state_;
  QDoubleSpinBox* speed_;
  QDoubleSpinBox* depth_;
  TextLabel* verdict_;
  QLabel* detail_;
  QLabel* note_;  // under the pockets: what brackets mean, or what to do where there are none
  QTableView* pockets_;
  PocketTable* table_;
  Panel* side_;
  QGridLayout* grid_;
};

}  // namespace stillcut::ui
